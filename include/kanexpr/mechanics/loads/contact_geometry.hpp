#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/loads/contact_shapes.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/orientation.hpp>
#include <kanexpr/mechanics/model/position.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/functions.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/substitute.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <string_view>

/// The shapes that touch in a contact, and where they do.
namespace kanexpr::mechanics {

/// A direction that is fixed in a frame.
struct contact_direction {
  int frame = none;
  components unit{};
  std::string_view mistake{}; ///< the end of a sentence; empty if there is none
};

/// The unit vector along a vector that is given in the axes of one frame.
constexpr contact_direction contact_direction_of(const mechanism& m, const vector& v) {
  contact_direction d{none, components(*m.g), {}};
  for (const vector::part& p : v.parts) {
    if (p.value.is_zero()) continue;
    if (d.frame != none) d.mistake = " is given in the axes of two frames; write it in the axes of one";
    d.frame = p.frame, d.unit = p.value;
  }
  if (d.frame == none) {
    d.mistake = " is zero";
    return d;
  }
  const expression squared = dot(d.unit, d.unit);
  if (!squared.is_one()) d.unit = (1 / sqrt(squared)) * d.unit;
  return d;
}

/// The coordinates of a point, as symbols in the function that describes a surface.
constexpr components surface_coordinates(graph& g) {
  const auto along = [&](const char* called, int i) {
    return symbolic::variable(g, {symbolic::symbol_kind::direction, name(called), i});
  };
  return {along("surface::x", 0), along("surface::y", 1), along("surface::z", 2)};
}

/// Two bodies at their closest points, in the axes of the second body.
struct touching {
  expression penetration{}; ///< δ, negative if there is a gap
  components push{};        ///< −∂δ/∂P for the point P of the first body, or the contact if it turns
  components normal{};      ///< the unit vector from the second body to the first
  components line{};        ///< from the point of the second body to that of the first
  components arm{};         ///< from the point of the first body to the contact
};

/// Two shapes that may touch. Each body is given by a point and a frame; a body without a frame is a point,
/// which has no rotation.
struct contact_geometry {
  contact_shapes shapes{};
  int point = none;          ///< the center of the sphere or torus
  int against = none;        ///< a point of the plane, or the center of the other sphere
  int frame = none;          ///< the frame of the first body
  int other = none;          ///< the frame of the second body
  components normal{};       ///< the unit normal of the plane, in the axes of `other`
  components axis{};         ///< the unit axis of the torus, in the axes of `axis_frame`
  int axis_frame = none;     ///< a frame in which the axis of the torus is fixed
  expression radius{};       ///< of the sphere, or of the tube of a torus
  expression other_radius{}; ///< of the other sphere, or of the circle around the axis of a torus
  expression level{};        ///< of a surface: φ in terms of `surface_coordinates`, positive outside

  template <class Self, class Visit>
  static constexpr void each_member(Self& self, Visit&& visit) {
    visit(self.shapes, self.point, self.against, self.frame, self.other, self.normal, self.axis,
          self.axis_frame, self.radius, self.other_radius, self.level);
  }

  constexpr touching at(const mechanism& m) const {
    touching t;
    t.line = express(m, position_from(m, against, point), other);
    switch (shapes) {
    case contact_shapes::sphere_on_plane:
      t.push = t.normal = normal;
      t.penetration = radius - dot(normal, t.line);
      t.arm = -(radius * normal);
      return t;
    case contact_shapes::torus_on_plane: lay_torus(t, express_axis(m)); return t;
    case contact_shapes::sphere_on_sphere: {
      const expression distance = sqrt(dot(t.line, t.line)), inverse = 1 / distance;
      t.push = t.normal = inverse * t.line;
      const expression reach = radius + other_radius;
      t.penetration = reach - distance;
      t.arm = -(radius * t.normal);
      return t;
    }
    case contact_shapes::point_on_surface: approach_surface(t); return t;
    }
    __builtin_unreachable();
  }

  /// Whether the contact is on the line through the center along the normal, so that a normal force has no
  /// moment about the center.
  constexpr bool is_round() const { return shapes != contact_shapes::torus_on_plane; }

  /// Whether the axis of a torus is parallel to the normal in every configuration.
  constexpr bool is_singular(const mechanism& m) const {
    return shapes == contact_shapes::torus_on_plane && cross(normal, express_axis(m)).is_zero();
  }
  /// Whether the second body is a plane, whose normal is fixed in it.
  constexpr bool has_plane() const {
    return shapes == contact_shapes::sphere_on_plane || shapes == contact_shapes::torus_on_plane;
  }

  /// Unit vectors, in the axes of the second body, whose span contains the slip: two tangents of a plane, or
  /// the three axes if the plane of contact turns. None if all components of the normal differ from zero and
  /// depend on parameters, because no axis is then known to be across the normal.
  constexpr sequence<components> directions_of_slip() const {
    if (!has_plane()) return {axis_of_other(0), axis_of_other(1), axis_of_other(2)};
    for (int i = 0; i < 3; ++i) {
      const int next = (i + 1) % 3, last = (i + 2) % 3;
      if (normal[i].is_zero() || !(normal[next].is_zero() || normal[last].is_zero())) continue;
      const components across = axis_of_other(normal[next].is_zero() ? next : last);
      return {across, cross(normal, across)};
    }
    if (!normal.is_constant()) return {};
    const components closest = axis_of_other(least_component_of_normal());
    const components across = closest - dot(normal, closest) * normal, tangent = scaled_to_one(across);
    return {tangent, cross(normal, tangent)};
  }

private:
  constexpr components axis_of_other(int i) const {
    components e(radius.owner());
    e[i] = expression{radius.owner(), graph::one};
    return e;
  }
  static constexpr components scaled_to_one(const components& v) { return (1 / sqrt(dot(v, v))) * v; }

  constexpr int least_component_of_normal() const {
    int least = 0;
    double size = 2;
    for (int i = 0; i < 3; ++i) {
      const double n = normal[i].owner().number_at(normal[i].node()).value();
      if (n * n < size) least = i, size = n * n;
    }
    return least;
  }

  /// The distance of a point from a surface is φ/|∇φ| to the first order. The elastic force is the derivative
  /// of this, so that it has a potential energy; on the surface itself, it is along the normal ∇φ/|∇φ|.
  constexpr void approach_surface(touching& t) const {
    graph& g = level.owner();
    const components place = surface_coordinates(g), gradient = gradient_of(level, place);
    const expression inverse = 1 / sqrt(dot(gradient, gradient)), distance = level * inverse;
    const components push = gradient_of(distance, place);
    symbolic::substitution there(g);
    for (int i = 0; i < 3; ++i) there.replace(place[i], t.line[i]);
    t.penetration = -there.in(distance);
    const expression scale = there.in(inverse);
    for (int i = 0; i < 3; ++i) t.push[i] = there.in(push[i]);
    t.normal = components(g), t.arm = components(g);
    for (int i = 0; i < 3; ++i) t.normal[i] = scale * there.in(gradient[i]);
  }
  static constexpr components gradient_of(expression e, const components& place) {
    components d;
    for (int i = 0; i < 3; ++i) d[i] = symbolic::differentiate(e, place[i]);
    return d;
  }

  constexpr components express_axis(const mechanism& m) const {
    vector along;
    along.add(axis_frame, axis);
    return express(m, along, other);
  }

  /// The lowest point of a torus is at R e − r n from its center, where e is the direction across the axis
  /// that points most against n. It is undefined if the axis is along n.
  constexpr void lay_torus(touching& t, const components& a) const {
    const expression cosine = dot(normal, a);
    const components across = cross(normal, a);
    const expression sine = sqrt(dot(across, across));
    const components down = cosine * a - normal; // e sine
    t.push = t.normal = normal;
    const expression height = dot(normal, t.line), reach = radius + other_radius * sine;
    t.penetration = reach - height;
    t.arm = (other_radius / sine) * down - radius * normal;
  }
};

} // namespace kanexpr::mechanics
