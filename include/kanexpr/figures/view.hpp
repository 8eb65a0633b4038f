#pragma once

#include <kanexpr/base/engine.hpp>
#include <kanexpr/figures/geometry.hpp>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

namespace kanexpr::figures {

/// An orthographic view with right-handed axes: to the right, upward and toward the eye.
struct view {
  Eigen::Vector3d right, up, eye;
  bool is_planar = false; ///< everything lies and turns in a plane perpendicular to `eye`

  /// The picture of a vector.
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

/// The view of a textbook: of a planar system, perpendicular to its plane; of a spatial one, from above and
/// from a side. Upward is opposite to gravity, otherwise along N.y in a plane and along N.z in space.
KANEXPR_ENGINE view view_of(const geometry& g);

/// A view in which `upward`, in inertial axes, is up as far as the view permits.
KANEXPR_ENGINE view view_of(const geometry& g, const Eigen::Vector3d& upward);

} // namespace kanexpr::figures

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/figures/view.ipp>
#endif
