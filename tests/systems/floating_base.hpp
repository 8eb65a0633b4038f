// The quadruped's reference takes the base's velocity in ground axes, the model in the base's own: a = R (v̇ +
// ω×v).
#pragma once

#include "systems/check_robot_against_oracle.hpp"

#include <Eigen/Geometry>

namespace check {

struct floating {
  // `x` with the speeds of the reference.
  template <class State>
  static convention at(const State& x) {
    const Eigen::Matrix3d R = Eigen::Quaterniond(x.template segment<4>(3)).toRotationMatrix();
    const auto u = x.u();
    convention c{MatrixXd::Identity(u.size(), u.size()), VectorXd::Zero(u.size())};
    c.turn.topLeftCorner<3, 3>() = R;
    c.extra.head<3>() = u.template segment<3>(3).cross(R.transpose() * u.template head<3>());
    return c;
  }
};

} // namespace check
