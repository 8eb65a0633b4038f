// expect: speed v appears in no kinematic differential equation
#include "pendulum.hpp"

#include <Eigen/Dense>

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u, v>, kinematics<dot(q) == u>, bodies<Bob>> {
};

int main() {
  using eom = equations_of_motion<System>;
  eom::state x(0.1, 0.2, 0.3);
  Eigen::Vector2d p(1, 2);
  const Eigen::Matrix2d M = eom::mass_matrix(x, p);
  const Eigen::Vector2d f = eom::forcing(x, p);
  const Eigen::Vector2d udot = M.ldlt().solve(f);
  const double energy = 2 * eom::kinetic_energy(x, p);
  auto [a, b] = eom::together(eom::mass_matrix, eom::forcing)(x, p);
  return udot(0) + energy + a(0, 0) + b(1) > 0;
}
