#pragma once

#include <kanexpr/animate/word_record.hpp>
#include <kanexpr/mechanics/motion/triple.hpp>

#include <Eigen/Geometry>

#include <cmath>

/// Converts the numbers of an attachment to a placement.
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

inline Eigen::Vector3d triple(const double* numbers) { return {numbers[0], numbers[1], numbers[2]}; }

inline Eigen::Matrix3d axes_of(const word_record& r, const double* numbers) {
  if (r.has_axis) return about_axis(triple(numbers), triple(numbers + 3), triple(numbers + 6));
  Eigen::Matrix3d axes;
  axes.col(0) = triple(numbers);
  axes.col(1) = triple(numbers + 3);
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return axes;
}

inline placement placed(const word_record& r, const double* numbers) {
  placement here;
  here.position = triple(numbers);
  if (r.placed_by == placing::ends) here.end = triple(numbers + 3);
  if (r.placed_by == placing::pose) here.orientation = axes_of(r, numbers + 3);
  return here;
}

} // namespace kanexpr::animate
