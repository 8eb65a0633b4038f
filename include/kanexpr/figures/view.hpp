#pragma once

#include <kanexpr/figures/geometry.hpp>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

namespace kanexpr::figures {

/// An orthographic view with right-handed axes: to the right, upward and toward the eye.
struct view {
  Eigen::Vector3d right, up, eye;
  bool is_planar = false; ///< all points lie, and all frames rotate, in a plane perpendicular to `eye`

  /// The projection of a vector onto the picture.
  Eigen::Vector2d operator()(const Eigen::Vector3d& v) const { return {v.dot(right), v.dot(up)}; }
  double toward_eye(const Eigen::Vector3d& v) const { return v.dot(eye); }
};

namespace detail {

/// Whether all points lie in a plane perpendicular to a unit vector, and all frames have an axis along it.
inline bool is_planar(const geometry& g, const Eigen::Vector3d& normal) {
  constexpr double tolerance = 1e-9;
  for (const Eigen::Vector3d& p : g.points)
    if (std::abs(normal.dot(p - g.points.front())) > tolerance * g.size) return false;
  for (const Eigen::Matrix3d& axes : g.frames)
    if ((axes.transpose() * normal).cwiseAbs().maxCoeff() < 1 - tolerance) return false;
  return true;
}

inline view view_along(const Eigen::Vector3d& eye, const Eigen::Vector3d& upward) {
  const Eigen::Vector3d right = upward.cross(eye).normalized();
  return {right, eye.cross(right), eye};
}

} // namespace detail

/// A view in which `upward`, in inertial axes, points up as far as the view permits.
inline view view_of(const geometry& g, const Eigen::Vector3d& upward) {
  constexpr double nearly_one = 0.99;
  for (int axis : {2, 1, 0}) {
    const Eigen::Vector3d normal = Eigen::Vector3d::Unit(axis);
    if (std::abs(upward.normalized().dot(normal)) > nearly_one || !detail::is_planar(g, normal)) continue;
    view planar = detail::view_along(normal, upward);
    planar.is_planar = true;
    return planar;
  }
  constexpr double azimuth = 28 * std::numbers::pi / 180, elevation = 20 * std::numbers::pi / 180;
  const Eigen::Vector3d up = upward.normalized();
  int along = 0;
  up.cwiseAbs().maxCoeff(&along);
  const Eigen::Vector3d front =
      (Eigen::Vector3d::Unit((along + 1) % 3) - up * up((along + 1) % 3)).normalized();
  const Eigen::Vector3d side = up.cross(front);
  return detail::view_along((std::cos(elevation) * (std::cos(azimuth) * front + std::sin(azimuth) * side) +
                             std::sin(elevation) * up),
                            up);
}

/// The up direction, opposite to gravity; without gravity, along N.y in a plane and along N.z in space. A
/// planar system may move across gravity; it is then treated as one without.
inline Eigen::Vector3d upward_of(const geometry& g) {
  const auto nearest_axis = [](const Eigen::Vector3d& v) {
    int along = 0;
    v.cwiseAbs().maxCoeff(&along);
    return Eigen::Vector3d(Eigen::Vector3d::Unit(along));
  };
  if (!g.gravity.isZero()) {
    const Eigen::Vector3d up = -g.gravity.stableNormalized();
    const bool is_across = detail::is_planar(g, nearest_axis(up)) && g.points.size() > 1;
    if (!is_across) return up;
  }
  const bool is_in_z = detail::is_planar(g, Eigen::Vector3d::UnitZ());
  return is_in_z ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ();
}

/// The view that a textbook would use: a planar system is viewed perpendicular to its plane, a spatial one
/// obliquely from above.
inline view view_of(const geometry& g) { return view_of(g, upward_of(g)); }

} // namespace kanexpr::figures
