#pragma once

#include <Eigen/Geometry>

#include <cmath>

namespace kanexpr::animate {

/// Where a shape is at one time, in inertial axes.
struct placement {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d end = Eigen::Vector3d::Zero();             ///< of a shape between two points
  Eigen::Matrix3d orientation = Eigen::Matrix3d::Identity(); ///< its columns are the shape's axes
};

/// What of a placement a shape needs.
enum class placing : unsigned char {
  place, ///< a point
  ends,  ///< two points
  pose,  ///< a point and an orientation
};

/// The orientation whose z is along `axis`, and whose x is as near as possible to an axis of the frame that
/// has `x` and `y`: to x itself unless `axis` is within 30 degrees of it.
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
