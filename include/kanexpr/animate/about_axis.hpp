#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>

namespace kanexpr::animate {

/// Returns the orientation with z along `axis` and x as close as possible to the frame's axis `x`, or to `y`
/// if `axis` is within 30 degrees of `x`.
inline Eigen::Matrix3d about_axis(const Eigen::Vector3d& axis, const Eigen::Vector3d& x,
                                  const Eigen::Vector3d& y) {
  const Eigen::Vector3d z = axis.normalized();
  const Eigen::Vector3d across = std::abs(z.dot(x)) < std::sqrt(0.75) ? x : y;
  Eigen::Matrix3d r;
  r.col(0) = (across - across.dot(z) * z).normalized();
  r.col(1) = z.cross(r.col(0));
  r.col(2) = z;
  return r;
}

} // namespace kanexpr::animate
