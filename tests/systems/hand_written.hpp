// A reference that shares no code with kanexpr: positions and orientations of bodies, written by hand as
// functions of the coordinates in numbers that carry their first two time derivatives, and the Newton-Euler
// equations with multipliers, M q'' = f + J^T lambda and J q'' = c, solved together.
#pragma once

#include <Eigen/Core>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace hand_written {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using numbers = std::map<std::string, double>;

// A quantity with its first and second time derivative.
struct jet {
  double value = 0, rate = 0, second = 0;
  constexpr jet() = default;
  constexpr jet(double v) : value(v) {}
  constexpr jet(double v, double r, double s) : value(v), rate(r), second(s) {}
};

using jets = std::vector<jet>;
struct motion; // equations of a system for its coordinates and their rates

// Coordinates and speeds have the names used in examples/models; quantities that a model omits, such as the
// angle of a wheel, are also coordinates here.
struct system {
  std::vector<std::string> q, u;
  std::function<motion(const jets&)> move;
};

system chaplygin_sleigh(const numbers& parameters, double F, double T);
system four_bar(const numbers& parameters, double T);
system pendulum_nonminimal(const numbers& parameters);
system rolling_disc(const numbers& parameters);
system rolling_torus(const numbers& parameters);
system bicycle(const numbers& parameters);
system rattleback(const numbers& parameters);

struct solution {
  VectorXd acceleration; // of the coordinates
  VectorXd multipliers;
  VectorXd speeds, udot; // as chosen by the model under test
  double kinetic_energy;
  double power; // of all forces and torques
};

solution solve(const system& s, const VectorXd& q, const VectorXd& qdot);

// Moves q to a configuration that satisfies the constraints, by steps of minimum norm.
bool close(const system& s, VectorXd& q);

// The part of these rates that the constraints permit.
VectorXd allowed(const system& s, const VectorXd& q, const VectorXd& rates);

// The rates of the coordinates for the given speeds; names of speeds that are not given may be omitted.
VectorXd rates_for(const system& s, const VectorXd& q, const std::vector<std::string>& names,
                   const VectorXd& speeds);

// The values of `wanted`, zero for those that are not in `names`.
VectorXd pick(const std::vector<std::string>& wanted, const std::vector<std::string>& names,
              const VectorXd& values);

} // namespace hand_written
