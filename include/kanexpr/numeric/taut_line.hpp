#pragma once

#include <kanexpr/numeric/parts_on_surface.hpp>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

/// Places along the shortest line between two points around a cylinder, a sphere or a cone, for drawing. The
/// lengths of these lines are in `mechanics/loads/wrapping.hpp`.
namespace kanexpr::numeric {

/// A line as places along it. The parts between successive places are straight or belong to a smooth curve.
struct taut_line {
  std::vector<Eigen::Vector3d> places{};
  std::vector<std::size_t> straight_parts{}; ///< part i is between the places i and i + 1
};

enum class wrapped_solid : unsigned char { cylinder, sphere, cone };

/// A surface around which a line is wrapped.
struct wrapped_surface {
  wrapped_solid form{};
  Eigen::Vector3d center = Eigen::Vector3d::Zero(); ///< a point of the axis; of a cone, its tip
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< of a cone, from the tip into the cone
  double size = 0; ///< the radius; of a cone, the angle between the axis and the surface
  int sense = 1;   ///< 1 if the line turns counterclockwise about the axis
  bool first_is_on_surface = false, last_is_on_surface = false;

  bool touches_always() const { return first_is_on_surface && last_is_on_surface; }
};

namespace detail {

/// An end of a wrapped line, relative to the center of the surface. The line touches the surface after it has
/// turned by `to_tangent` about the axis; in the plane across the axis, this takes the length `tangent`.
struct wrapped_end {
  double height = 0;
  Eigen::Vector3d radial = Eigen::Vector3d::Zero();
  double tangent = 0, to_tangent = 0;

  wrapped_end(const Eigen::Vector3d& place, const Eigen::Vector3d& axis)
      : height(place.dot(axis)), radial(place - height * axis) {}

  void touch(double radius, bool is_on_surface) {
    if (is_on_surface) return;
    tangent = std::sqrt(radial.squaredNorm() - radius * radius);
    to_tangent = std::atan2(tangent, radius);
  }
};

/// The places of a line on a surface, with its straight ends; `on_surface(part)` is the place after the given
/// part, from 0 to 1, of the wrapped angle.
template <class Place>
taut_line wrapped_line(const wrapped_surface& s, const Eigen::Vector3d& first, const Eigen::Vector3d& last,
                       const Place& on_surface) {
  taut_line line;
  if (!s.first_is_on_surface) {
    line.straight_parts.push_back(0);
    line.places.push_back(first);
  }
  for (std::size_t i = 0; i <= parts_on_surface; ++i)
    line.places.push_back(s.center +
                          on_surface(static_cast<double>(i) / static_cast<double>(parts_on_surface)));
  if (!s.last_is_on_surface) {
    line.straight_parts.push_back(line.places.size() - 1);
    line.places.push_back(last);
  }
  return line;
}

/// A line that does not touch the surface; it has as many places as one that does.
inline taut_line untouched_line(const wrapped_surface& s, const Eigen::Vector3d& first,
                                const Eigen::Vector3d& last) {
  const double before = s.first_is_on_surface ? 0 : 1, after = s.last_is_on_surface ? 0 : 1;
  const double parts = static_cast<double>(parts_on_surface);
  return wrapped_line(s, first, last, [&](double part) -> Eigen::Vector3d {
    return first + (before + part * parts) / (before + parts + after) * (last - first) - s.center;
  });
}

/// The angle about the axis between the places at which the line touches the surface.
inline double wrapped_angle(const wrapped_surface& s, const wrapped_end& first, const wrapped_end& last) {
  const double tangents = first.to_tangent + last.to_tangent;
  double turned =
      std::atan2(s.sense * s.axis.dot(first.radial.cross(last.radial)), first.radial.dot(last.radial));
  if (turned + tangents < 0) turned += 2 * std::numbers::pi;
  return turned - tangents;
}

inline taut_line around_cylinder(const wrapped_surface& s, const Eigen::Vector3d& first,
                                 const Eigen::Vector3d& last) {
  wrapped_end p(first - s.center, s.axis), q(last - s.center, s.axis);
  p.touch(s.size, s.first_is_on_surface), q.touch(s.size, s.last_is_on_surface);
  const double angle = wrapped_angle(s, p, q), arc = s.size * angle, across = p.tangent + arc + q.tangent;
  if (angle <= 0 && !s.touches_always()) return untouched_line(s, first, last);
  const Eigen::Vector3d outward = p.radial.normalized();
  return wrapped_line(s, first, last, [&](double part) -> Eigen::Vector3d {
    const double height = p.height + (q.height - p.height) * (p.tangent + part * arc) / across;
    const Eigen::AngleAxisd turned(s.sense * (p.to_tangent + part * angle), s.axis);
    return height * s.axis + s.size * (turned * outward);
  });
}

inline taut_line around_sphere(const wrapped_surface& s, const Eigen::Vector3d& first,
                               const Eigen::Vector3d& last) {
  const Eigen::Vector3d p = first - s.center, q = last - s.center, normal = p.cross(q);
  const auto to_tangent = [&](const Eigen::Vector3d& end, bool is_on_surface) {
    return is_on_surface ? 0 : std::acos(s.size / end.norm());
  };
  const double before = to_tangent(p, s.first_is_on_surface), after = to_tangent(q, s.last_is_on_surface);
  const double angle = std::atan2(normal.norm(), p.dot(q)) - before - after;
  if (angle <= 0 && !s.touches_always()) return untouched_line(s, first, last);
  const Eigen::Vector3d outward = p.normalized(), along = normal.cross(p).normalized();
  return wrapped_line(s, first, last, [&](double part) -> Eigen::Vector3d {
    const double turned = before + part * angle;
    return s.size * (std::cos(turned) * outward + std::sin(turned) * along);
  });
}

/// In the development of the cone, the line is straight.
inline taut_line around_cone(const wrapped_surface& s, const Eigen::Vector3d& first,
                             const Eigen::Vector3d& last) {
  wrapped_end p(first - s.center, s.axis), q(last - s.center, s.axis);
  const double sine = std::sin(s.size), cosine = std::cos(s.size), slope = sine / cosine;
  p.touch(p.height * slope, s.first_is_on_surface), q.touch(q.height * slope, s.last_is_on_surface);
  const double angle = wrapped_angle(s, p, q);
  if (angle <= 0 && !s.touches_always()) return untouched_line(s, first, last);
  const double before = std::atan2(p.tangent, p.height / cosine),
               after = std::atan2(q.tangent, q.height / cosine), developed = before + sine * angle + after;
  const double a = (first - s.center).norm(), b = (last - s.center).norm();
  const double doubled_area =
      developed < std::numbers::pi ? a * b * std::sin(developed) : std::numeric_limits<double>::quiet_NaN();
  const Eigen::Vector3d outward = p.radial.normalized();
  return wrapped_line(s, first, last, [&](double part) -> Eigen::Vector3d {
    const double here = before + part * sine * angle;
    const double from_tip = doubled_area / (a * std::sin(here) + b * std::sin(developed - here));
    const Eigen::AngleAxisd turned(s.sense * (p.to_tangent + part * angle), s.axis);
    return from_tip * (cosine * s.axis + sine * (turned * outward));
  });
}

} // namespace detail

/// The straight lines from place to place.
inline taut_line straight_lines(std::vector<Eigen::Vector3d> places) {
  taut_line line{std::move(places), {}};
  for (std::size_t i = 0; i + 1 < line.places.size(); ++i) line.straight_parts.push_back(i);
  return line;
}

/// The shortest line between two points around a surface. An end inside the surface, and a line that would
/// slip over the tip of a cone, gives NaN.
inline taut_line line_around(const wrapped_surface& s, const Eigen::Vector3d& first,
                             const Eigen::Vector3d& last) {
  switch (s.form) {
  case wrapped_solid::cylinder: return detail::around_cylinder(s, first, last);
  case wrapped_solid::sphere: return detail::around_sphere(s, first, last);
  case wrapped_solid::cone: return detail::around_cone(s, first, last);
  }
  return {};
}

} // namespace kanexpr::numeric
