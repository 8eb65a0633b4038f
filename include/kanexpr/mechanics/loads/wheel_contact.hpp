#pragma once

#include <kanexpr/mechanics/loads/contact_geometry.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/functions.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/substitute.hpp>

/// The place where a wheel touches the ground. All vectors are in the axes of the ground. The axis of a wheel
/// points to its left, so that a wheel with a positive spin rolls forward.
namespace kanexpr::mechanics {

/// A wheel on the ground, at its lowest point.
struct wheel_contact {
  expression penetration{}; ///< δ, by which the undeformed wheel overlaps the ground; negative if it is above
  components normal{};      ///< the unit normal of the ground, upward
  components forward{};     ///< the unit vector along axis × normal
  components lateral{};     ///< the unit vector along normal × forward, to the left
  components axis{};        ///< the unit vector along the axle
  components line{};        ///< from the point of the ground to the center of the wheel
  components lowest{};      ///< from the center to the lowest point of the undeformed wheel
  components arm{};         ///< from the center to the contact point, at the height of the ground
  expression camber_sine{}; ///< axis · normal; positive if the top leans to the right (ISO 8855)
  expression loaded_radius{}; ///< the distance of the contact point from the axle
};

namespace detail {

/// Completes a contact from its penetration and normal, the point of the undeformed wheel, and the unit
/// vector `radial` from the axle toward that point.
constexpr void finish_contact(wheel_contact& at, const components& lowest, const components& radial) {
  at.camber_sine = dot(at.axis, at.normal);
  const expression inverse = 1 / sqrt(1 - at.camber_sine * at.camber_sine);
  at.forward = inverse * cross(at.axis, at.normal);
  at.lateral = inverse * (at.axis - at.camber_sine * at.normal);
  at.lowest = lowest;
  at.arm = lowest + at.penetration * at.normal;
  at.loaded_radius = dot(at.arm, radial);
}

/// A point of the rim of a torus. The circle of the centers of the tube has the radius `circle`.
struct rim_point {
  components radial{};         ///< e, the unit vector from the center to the center of the tube
  expression cosine{}, sine{}; ///< of the angle from e to the outward normal, toward the axis
  constexpr components outward(const components& axis) const { return cosine * radial + sine * axis; }
};

/// The lowest point with respect to the normal n: its outward normal is −n.
constexpr rim_point lowest_along(const components& normal, const components& axis) {
  const expression along = dot(normal, axis), across = sqrt(1 - along * along);
  return {(1 / across) * (along * axis - normal), across, -along};
}

/// The height f of the ground and its derivatives at a place, where its argument is a function of
/// `surface_coordinates`.
struct ground_height {
  expression value{}, x{}, y{}, xx{}, xy{}, yy{};

  constexpr ground_height(expression f, const components& at) {
    graph& g = f.owner();
    const components place = surface_coordinates(g);
    symbolic::substitution there(g);
    for (int i = 0; i < 3; ++i) there.replace(place[i], at[i]);
    const expression fx = symbolic::differentiate(f, place.x), fy = symbolic::differentiate(f, place.y);
    value = there.in(f), x = there.in(fx), y = there.in(fy);
    xx = there.in(symbolic::differentiate(fx, place.x));
    xy = there.in(symbolic::differentiate(fx, place.y));
    yy = there.in(symbolic::differentiate(fy, place.y));
  }

  /// An upward normal, which is not a unit vector: (−∂f/∂x, −∂f/∂y, 1).
  constexpr components upward() const { return {-x, -y, x.number(symbolic::exactly(1))}; }
  /// aᵀ H b, where H is the matrix of the second derivatives.
  constexpr expression bend(const components& a, const components& b) const {
    const expression along_x = a.x * (xx * b.x + xy * b.y), along_y = a.y * (xy * b.x + yy * b.y);
    return along_x + along_y;
  }
};

} // namespace detail

/// A torus or, if the radius of its tube is zero, a thin wheel on the plane through a point.
constexpr wheel_contact touch_plane(const components& line, const components& axis, const components& normal,
                                    expression circle, expression tube) {
  wheel_contact at;
  at.line = line, at.axis = axis, at.normal = normal;
  const detail::rim_point lowest = detail::lowest_along(normal, axis);
  at.penetration = circle * lowest.cosine + tube - dot(normal, line);
  detail::finish_contact(at, circle * lowest.radial - tube * normal, lowest.radial);
  return at;
}

namespace detail {

constexpr components on_rim(const rim_point& p, const components& axis, expression circle, expression tube) {
  const components center = circle * p.radial;
  return tube.is_zero() ? center : center + tube * p.outward(axis);
}

/// One step of Newton's method toward the point of the rim at which the height above the ground, measured
/// along z, is least. The unknowns are the angles around the axis and around the tube.
constexpr rim_point descend(const rim_point& p, const components& line, const components& axis,
                            expression circle, expression tube, expression f) {
  const ground_height h(f, line + on_rim(p, axis, circle, tube));
  const components up = h.upward(), around = cross(axis, p.radial);
  const expression slope = dot(up, around);
  rim_point next = p;
  const auto turned = [](const auto& a, expression by, const auto& b) {
    const expression scale = 1 / sqrt(1 + by * by);
    return scale * (a + by * b);
  };
  if (tube.is_zero()) {
    const expression curvature = -dot(up, p.radial) - circle * h.bend(around, around);
    next.radial = turned(p.radial, -slope / curvature, around);
    return next;
  }
  const components outward = p.outward(axis), over = p.cosine * axis - p.sine * p.radial;
  const expression tilt = dot(up, over), reach = circle + tube * p.cosine;
  const expression mixed = h.bend(around, over), shear = p.sine * slope;
  const expression a = -dot(up, p.radial) - reach * h.bend(around, around);
  const expression b = -(shear * tube / reach) - tube * mixed;
  const expression c = -shear - reach * mixed, d = -dot(up, outward) - tube * h.bend(over, over);
  const expression determinant = a * d - b * c;
  const expression around_by = (b * tilt - d * slope) / determinant;
  const expression over_by = (c * slope - a * tilt) / determinant;
  next.radial = turned(p.radial, around_by, around);
  next.cosine = turned(p.cosine, over_by, -p.sine);
  next.sine = turned(p.sine, over_by, p.cosine);
  return next;
}

} // namespace detail

/// A torus or a thin wheel on the surface z = f(x, y), with f in terms of `surface_coordinates`.
///
/// The lowest point has no closed form. The search starts with the tangent plane below the center, takes a
/// fixed number of steps of Newton's method, and measures the penetration along the normal below the point
/// that it found. It requires that the ground is less curved than the wheel; otherwise the wheel touches it
/// at two points.
constexpr wheel_contact touch_surface(const components& line, const components& axis, expression circle,
                                      expression tube, expression f, int steps) {
  wheel_contact at;
  at.line = line, at.axis = axis;
  const components below = unit_along(detail::ground_height(f, line).upward());
  detail::rim_point p = detail::lowest_along(below, axis);
  for (int i = 0; i < steps; ++i) p = detail::descend(p, line, axis, circle, tube, f);
  const components lowest = detail::on_rim(p, axis, circle, tube), place = line + lowest;
  const detail::ground_height h(f, place);
  const components up = h.upward();
  const expression inverse = 1 / sqrt(dot(up, up));
  at.normal = inverse * up;
  at.penetration = (h.value - place.z) * inverse;
  detail::finish_contact(at, lowest, p.radial);
  return at;
}

/// A straight rail. Its head is a circular cylinder.
struct rail_head {
  components along{};  ///< the unit vector along the rail
  components up{};     ///< the unit vector across it, toward the wheel
  expression radius{}; ///< of the head
};

/// A conical wheel on a rail whose uppermost line contains a point. The radius of the wheel at its center is
/// given and grows by the conicity with the distance along the axis. This is exact: a cone and a cylinder
/// touch where their normals are parallel.
constexpr wheel_contact touch_rail(const components& line, const components& axis, expression radius,
                                   expression conicity, const rail_head& on) {
  wheel_contact at;
  at.line = line, at.axis = axis;
  // e·t = λ a·t makes the outward normal e − λ a of the cone perpendicular to the rail.
  const expression along = dot(on.along, axis);
  const components across = on.along - along * axis;
  const expression size = sqrt(1 - along * along);
  const components ahead = (1 / size) * across;
  const components down = -unit_along(on.up - dot(on.up, axis) * axis - dot(on.up, ahead) * ahead);
  const expression forward_part = conicity * along / size;
  const components radial = forward_part * ahead + sqrt(1 - forward_part * forward_part) * down;
  const expression inverse = 1 / sqrt(1 + conicity * conicity);
  at.normal = -(inverse * (radial - conicity * axis));
  // The distance along the axis at which the normal passes through the center line of the head.
  const components sideways = cross(on.along, at.normal), generator = axis + conicity * radial;
  const components from_center_line = line + on.radius * on.up + radius * radial;
  const expression distance = -dot(from_center_line, sideways) / dot(generator, sideways);
  at.penetration = on.radius - dot(from_center_line, at.normal);
  detail::finish_contact(at, radius * radial + distance * generator, radial);
  return at;
}

} // namespace kanexpr::mechanics
