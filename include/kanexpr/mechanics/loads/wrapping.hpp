#pragma once

#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/symbolic/graph/composed.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/functions.hpp>
#include <kanexpr/symbolic/numbers/number.hpp>

/// The shortest lines between two points around a cylinder, a sphere or a cone. Each consists of a geodesic
/// of the surface and of straight lines that are tangent to the surface.
///
/// A cylinder and a cone can be developed into a plane together with the tangent planes that contain the
/// straight lines; the whole line is then straight. While the line between the points does not touch the
/// surface, it is the straight line in space; the length and its gradients are continuous where it lifts off.
namespace kanexpr::mechanics {

/// A line between two points around a surface: its length, and the gradients of the length with respect to
/// the positions of the points, which are the unit vectors along the line, away from it.
struct wrapped_line {
  expression length{};
  components at_first{}, at_last{};
};

/// The straight line from p to q.
constexpr wrapped_line straight_line(const components& p, const components& q) {
  const components d = q - p;
  const expression length = sqrt(dot(d, d));
  const expression scale = 1 / length;
  const components along = scale * d;
  return {length, -along, along};
}

namespace detail {

constexpr components selected(expression condition, const components& positive, const components& other) {
  return {if_positive(condition, positive.x, other.x), if_positive(condition, positive.y, other.y),
          if_positive(condition, positive.z, other.z)};
}

/// The line that touches the surface if the wrapped angle is positive, and the straight line otherwise.
constexpr wrapped_line touching_if(expression wrapped_angle, const wrapped_line& touching,
                                   const wrapped_line& straight) {
  return {if_positive(wrapped_angle, touching.length, straight.length),
          selected(wrapped_angle, touching.at_first, straight.at_first),
          selected(wrapped_angle, touching.at_last, straight.at_last)};
}

/// An end of a line around a surface of revolution, in cylindrical coordinates. The straight line touches the
/// surface along the meridian at the angle `to_tangent` from the end.
struct wrapped_end {
  expression height{};     ///< along the axis
  components radial{};     ///< from the axis
  components around{};     ///< the axis times `radial`
  expression square{};     ///< the square of the distance from the axis
  expression tangent{};    ///< the distance from the meridian, in the plane across the axis
  expression to_tangent{}; ///< the angle about the axis from the end to the meridian

  /// `radius` is that of the surface at the height of the end.
  constexpr void touch(expression radius, bool is_on_surface) {
    tangent = to_tangent = square.number(symbolic::exactly(0));
    if (is_on_surface) return;
    tangent = sqrt(square - radius * radius);
    to_tangent = atan2(tangent, radius);
  }
};

constexpr wrapped_end end_at(const components& p, const components& axis) {
  wrapped_end e;
  e.height = dot(p, axis);
  e.radial = p - e.height * axis;
  e.around = cross(axis, e.radial);
  e.square = dot(e.radial, e.radial);
  return e;
}

/// The angle about the axis through which the line touches the surface on its way from one end to the other,
/// less than 2π. `sense` is 1 if the line turns counterclockwise about the axis and −1 otherwise. At the
/// angle at which the straight line is tangent to the wrong side of the surface, the line jumps to the other
/// side.
constexpr expression wrapped_angle(const wrapped_end& p, const wrapped_end& q, int sense) {
  expression sine = dot(p.around, q.radial);
  if (sense < 0) sine = -sine;
  const expression turned = atan2(sine, dot(p.radial, q.radial));
  const expression tangents = p.to_tangent + q.to_tangent;
  const expression whole_turn = sine.number(symbolic::real(2 * 3.14159265358979323846));
  const expression none = sine.number(symbolic::exactly(0));
  return turned + if_positive(-(turned + tangents), whole_turn, none) - tangents;
}

} // namespace detail

/// A surface around which a line is wrapped: the axis is a unit vector, and the origin is a point of it.
struct wrapped_surface {
  components axis{};
  expression size{}; ///< the radius; of a cone, the angle between the axis and the surface
  int sense = 1;     ///< 1 if the line from the first point to the last turns counterclockwise about the axis
  bool first_is_on_surface = false, last_is_on_surface = false;

  constexpr bool touches_always() const { return first_is_on_surface && last_is_on_surface; }
};

/// √((L + r φ)² + h²), where L is the length of the tangents across the axis, φ the wrapped angle and h the
/// distance along the axis.
constexpr wrapped_line line_around_cylinder(const wrapped_surface& s, const components& p,
                                            const components& q) {
  detail::wrapped_end first = detail::end_at(p, s.axis), last = detail::end_at(q, s.axis);
  first.touch(s.size, s.first_is_on_surface);
  last.touch(s.size, s.last_is_on_surface);
  const expression angle = detail::wrapped_angle(first, last, s.sense);
  const expression across = first.tangent + last.tangent + s.size * angle, along = last.height - first.height;
  wrapped_line line;
  line.length = along.is_zero() ? across : sqrt(sum_of_products(across, across, along, along));
  const expression slope = along / line.length, share = across / line.length;
  const auto away = [&](const detail::wrapped_end& e, bool is_first) {
    const expression turning = (s.sense > 0) == is_first ? -s.size : s.size;
    components v = (share * e.tangent / e.square) * e.radial;
    v += (share * turning / e.square) * e.around;
    v += (is_first ? -slope : slope) * s.axis;
    return v;
  };
  line.at_first = away(first, true);
  line.at_last = away(last, false);
  return s.touches_always() ? line : detail::touching_if(angle, line, straight_line(p, q));
}

/// The tangents and the arc of the great circle through both points. If the center is between the points, the
/// plane of the line, and therefore its direction, is undefined.
constexpr wrapped_line line_around_sphere(const wrapped_surface& s, const components& p,
                                          const components& q) {
  const components normal = cross(p, q);
  const expression sine = sqrt(dot(normal, normal)), cosine = dot(p, q);
  const expression radius = s.size, zero = radius.number(symbolic::exactly(0));
  const auto tangent = [&](const components& x, bool is_on_surface) {
    return is_on_surface ? zero : sqrt(dot(x, x) - radius * radius);
  };
  const auto angle_of = [&](expression length, bool is_on_surface) {
    return is_on_surface ? zero : atan2(length, radius);
  };
  const expression first = tangent(p, s.first_is_on_surface), last = tangent(q, s.last_is_on_surface);
  const expression of_first = angle_of(first, s.first_is_on_surface),
                   of_last = angle_of(last, s.last_is_on_surface);
  const expression angle = atan2(sine, cosine) - (of_first + of_last);
  const auto away = [&](const components& x, const components& other, expression length) {
    const expression square = dot(x, x);
    components toward = square * other; // perpendicular to x, with the length |x| sine
    toward -= cosine * x;
    components v = (length / square) * x;
    v -= (radius / (square * sine)) * toward;
    return v;
  };
  const wrapped_line line{first + last + radius * angle, away(p, q, first), away(q, p, last)};
  return s.touches_always() ? line : detail::touching_if(angle, line, straight_line(p, q));
}

/// √(a² + b² − 2 a b cos θ), where a and b are the distances of the points from the tip and θ is the angle
/// between them in the development. A line with θ > π would slip over the tip; its length is NaN.
constexpr wrapped_line line_around_cone(const wrapped_surface& s, const components& p, const components& q) {
  const expression slant_sine = sin(s.size), slant_cosine = cos(s.size);
  const expression slope = slant_sine / slant_cosine;
  detail::wrapped_end first = detail::end_at(p, s.axis), last = detail::end_at(q, s.axis);
  first.touch(first.height * slope, s.first_is_on_surface);
  last.touch(last.height * slope, s.last_is_on_surface);
  const expression angle = detail::wrapped_angle(first, last, s.sense);
  const auto in_tangent_plane = [&](const detail::wrapped_end& e) {
    return atan2(e.tangent, e.height / slant_cosine);
  };
  const expression of_first = in_tangent_plane(first), of_last = in_tangent_plane(last);
  const expression developed = of_first + of_last + slant_sine * angle;
  const expression a = sqrt(dot(p, p)), b = sqrt(dot(q, q));
  const expression cosine = cos(developed), sine = sin(developed);
  const expression square = sum_of_products(a, a, b, b) - 2 * (a * b) * cosine;
  const expression half_turn = square.number(symbolic::real(3.14159265358979323846));
  wrapped_line line;
  line.length = sqrt(if_positive(half_turn - developed, square, square.number(symbolic::exactly(-1))));
  const auto away = [&](const detail::wrapped_end& e, const components& x, expression own, expression other,
                        bool is_first) {
    const bool turns_back = (s.sense > 0) == is_first;
    components meridian = (e.height * slope) * e.radial; // times the square of the radius
    meridian += (turns_back ? e.tangent : -e.tangent) * e.around;
    components normal = (slant_cosine / e.square) * meridian;
    normal -= slant_sine * s.axis;
    const components turning = turns_back ? cross(normal, x) : cross(x, normal);
    components v = ((own - other * cosine) / (line.length * own)) * x;
    v += (other * sine / (line.length * own)) * turning;
    return v;
  };
  line.at_first = away(first, p, a, b, true);
  line.at_last = away(last, q, b, a, false);
  return s.touches_always() ? line : detail::touching_if(angle, line, straight_line(p, q));
}

} // namespace kanexpr::mechanics
