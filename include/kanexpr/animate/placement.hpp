#pragma once

#include <Eigen/Core>

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

} // namespace kanexpr::animate
