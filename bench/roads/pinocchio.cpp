// Writes Pinocchio's articulated body algorithm of a model, traced by CasADi, as C: pinocchio MODEL FOLDER.
#include "../peers/pinocchio/read_model.hpp"

#include <pinocchio/autodiff/casadi.hpp>

#include <pinocchio/algorithm/aba.hpp>

#include <filesystem>

int main(int, char** arguments) {
  using casadi::SX;
  const peers::robot robot = peers::read_model(arguments[1]);
  const pinocchio::ModelTpl<SX> model = robot.model.cast<SX>();
  pinocchio::DataTpl<SX> data(model);
  const casadi_int n = robot.model.nv;
  const SX x = SX::sym("x", 2 * n), r = SX::sym("r", n), p = SX::sym("p", 0);
  Eigen::Matrix<SX, Eigen::Dynamic, 1> q(n), v(n), torque(n);
  for (casadi_int i = 0; i < n; ++i) q(i) = x(i), v(i) = x(n + i), torque(i) = r(i);
  pinocchio::aba(model, data, q, v, torque);
  SX rate(2 * n, 1);
  for (casadi_int i = 0; i < n; ++i) rate(i) = x(n + i), rate(n + i) = data.ddq(i);
  const casadi::Function f("pinocchio", {x, r, p}, {rate}, {"x", "r", "p"}, {"rate"});
  std::filesystem::current_path(arguments[2]);
  f.save("pinocchio.casadi");
}
