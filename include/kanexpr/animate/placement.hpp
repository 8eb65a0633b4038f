#pragma once

#include <Eigen/Core>

namespace kanexpr::animate {

/// The placement of a shape at one time, in inertial axes.
struct placement {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d end = Eigen::Vector3d::Zero();             ///< second point of a shape between two points
  Eigen::Matrix3d orientation = Eigen::Matrix3d::Identity(); ///< its columns are the shape's axes
};

/// The parts of a placement that a shape uses.
enum class placing : unsigned char {
  place, ///< a point
  ends,  ///< two points
  pose,  ///< a point and an orientation
};

} // namespace kanexpr::animate
