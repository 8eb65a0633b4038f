// A reference that shares nothing with kanexpr: positions and orientations of bodies, written by hand as
// functions of coordinates in numbers that carry their first two derivatives in time, and Newton's and
// Euler's equations with multipliers, M q'' = f + J^T lambda and J q'' = c, solved together.
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

// A quantity with its rate and the rate of that.
struct jet {
  double value = 0, rate = 0, second = 0;
  constexpr jet() = default;
  constexpr jet(double v) : value(v) {}
  constexpr jet(double v, double r, double s) : value(v), rate(r), second(s) {}
};

using jets = std::vector<jet>;
struct motion; // what a system says of its coordinates and their rates

// Coordinates and speeds have the names of the models in examples/models; what a model leaves out, such as
// the angle of a wheel, is here a coordinate as well.
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
  VectorXd speeds, udot; // as the model under test chooses them
  double kinetic_energy;
  double power; // of all forces and torques
};

solution solve(const system& s, const VectorXd& q, const VectorXd& qdot);

// Moves q onto the configurations that are possible, by steps that are as short as can be.
bool close(const system& s, VectorXd& q);

// The part of these rates that the constraints allow.
VectorXd allowed(const system& s, const VectorXd& q, const VectorXd& rates);

// The rates of the coordinates that give these speeds; names of speeds that are not given may be missing.
VectorXd rates_for(const system& s, const VectorXd& q, const std::vector<std::string>& names,
                   const VectorXd& speeds);

// The values of `wanted`, zero where `names` does not have one.
VectorXd pick(const std::vector<std::string>& wanted, const std::vector<std::string>& names,
              const VectorXd& values);

} // namespace hand_written
