// expect: speed v appears in no kinematic differential equation
#include "pendulum.hpp"

#include <kanexpr/fixed_step.hpp>

#include <Eigen/Dense>

#include <string_view>

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
  const auto solved = eom::udot(x, p);
  if (!solved.status) return static_cast<int>(solved.status.cause().size());
  const double first = solved[0] + solved(0) + solved.norm();
  const auto velocity = kanexpr::function<System, velocity_of<P>>{}(x, p);
  const auto [A_matrix, B_matrix] = linearization<System>::explicit_form(x, p);
  if (!A_matrix.status || !velocity.status || !a.status) return 1;
  double t = 0;
  if (const status s = runge_kutta_4<System>{}(t, x, 1e-3, p); !s) return 1;
  if (first > A_matrix(0, 0) + velocity.x() + velocity[1]) return 1;
  return udot(0) + energy + a(0, 0) + b(1) > 0;
}
