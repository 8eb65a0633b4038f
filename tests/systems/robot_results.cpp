#include "systems/robot_results.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

namespace check {

convention on_the_ground(const VectorXd&, const VectorXd& u) {
  return {MatrixXd::Identity(u.size(), u.size()), VectorXd::Zero(u.size())};
}

convention floating_base(const VectorXd& q, const VectorXd& u) {
  convention seen = on_the_ground(q, u);
  const Eigen::Matrix3d R = Eigen::Quaterniond(q.segment<4>(3)).toRotationMatrix();
  seen.turn.topLeftCorner<3, 3>() = R;
  seen.extra.head<3>() = u.segment<3>(3).cross(R.transpose() * u.head<3>());
  return seen;
}

void expect_reference(const robot_results& model, const oracle::robot_state& s, const convention& seen,
                      Eigen::Index motors) {
  const MatrixXd& m = model.mass_matrix;
  const VectorXd& free = model.forcing_without_motors;
  EXPECT_TRUE(oracle::close(seen.turn * m * seen.turn.transpose(), s.mass_matrix, 1e-11));
  EXPECT_TRUE(oracle::close(seen.turn * (-free - m * seen.extra), s.bias, 1e-11));

  const VectorXd a = seen.turn.transpose() * s.a - seen.extra;
  EXPECT_TRUE(oracle::close(seen.turn * (m * a - free), s.inverse_dynamics, 1e-11));

  VectorXd on_base = seen.turn.transpose() * s.torque;
  on_base.tail(motors).setZero();
  const VectorXd udot = m.ldlt().solve(model.forcing + on_base);
  EXPECT_TRUE(oracle::close(seen.turn * (udot + seen.extra), s.udot, 1e-11));
  EXPECT_TRUE(oracle::close(model.udot, udot - m.ldlt().solve(on_base), 1e-11));
}

} // namespace check
