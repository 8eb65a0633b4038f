// Pinocchio's own algorithms, as a library for timing.
#include "read_model.hpp"

#include <pinocchio/algorithm/aba-derivatives.hpp>
#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/rnea.hpp>

#include <memory>

namespace {

using vector = Eigen::Map<const Eigen::VectorXd>;
using matrix = Eigen::Map<Eigen::MatrixXd>;

struct subject {
  explicit subject(const char* path)
      : robot(peers::read_model(path)), data(robot.model), torque(Eigen::VectorXd::Zero(robot.model.nv)) {}

  vector q(const double* x) const { return {x, robot.model.nq}; }
  vector v(const double* x) const { return {x + robot.model.nq, robot.model.nv}; }
  /// Of the last joints, for nothing drives a link that floats.
  const Eigen::VectorXd& torques(const double* x) {
    torque.tail(robot.inputs) = vector(x + robot.model.nq + robot.model.nv, robot.inputs);
    return torque;
  }

  peers::robot robot;
  pinocchio::Data data;
  Eigen::VectorXd torque;
};

std::unique_ptr<subject> now;

} // namespace

extern "C" {

void load(const char* path) { now = std::make_unique<subject>(path); }

void mass_matrix(const double* x, double* result) {
  auto& [robot, data, torque] = *now;
  const int n = robot.model.nv;
  pinocchio::crba(robot.model, data, now->q(x));
  matrix M(result, n, n);
  M.triangularView<Eigen::Upper>() = data.M.triangularView<Eigen::Upper>();
  M.triangularView<Eigen::StrictlyLower>() = M.transpose().triangularView<Eigen::StrictlyLower>();
}

void mass_matrix_and_forcing(const double* x, double* result) {
  auto& [robot, data, torque] = *now;
  const int n = robot.model.nv;
  mass_matrix(x, result);
  Eigen::Map<Eigen::VectorXd>(result + n * n, n) =
      now->torques(x) - pinocchio::nonLinearEffects(robot.model, data, now->q(x), now->v(x));
}

void udot(const double* x, double* result) {
  auto& [robot, data, torque] = *now;
  Eigen::Map<Eigen::VectorXd>(result, robot.model.nv) =
      pinocchio::aba(robot.model, data, now->q(x), now->v(x), now->torques(x));
}

/// By the tangent of the configuration, the speeds and the inputs.
void udot_derivatives(const double* x, double* result) {
  auto& [robot, data, torque] = *now;
  const int n = robot.model.nv;
  pinocchio::computeABADerivatives(robot.model, data, now->q(x), now->v(x), now->torques(x));
  matrix all(result, n, 2 * n + robot.inputs);
  all.leftCols(n) = data.ddq_dq;
  all.middleCols(n, n) = data.ddq_dv;
  data.Minv.triangularView<Eigen::StrictlyLower>() =
      data.Minv.transpose().triangularView<Eigen::StrictlyLower>();
  all.rightCols(robot.inputs) = data.Minv.rightCols(robot.inputs);
}
}
