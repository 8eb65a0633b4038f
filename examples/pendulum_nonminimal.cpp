// A pendulum by the coordinates of its bob, with the pull of its string.
#include "report.hpp"

#include <models/pendulum_nonminimal.hpp>

int main() {
  using namespace pendulum_nonminimal;
  using eom = kanexpr::equations_of_motion<System>;

  eom::state x;
  x[q1] = 0.5138727407870551;
  x[q2] = -0.475326;
  x[u1] = 1.4639300424766772;
  x[u2] = 1.582648;

  eom::parameters p;
  p[m] = 1.3;
  p[L] = 0.7;
  p[g] = 9.81;

  report check("pendulum_nonminimal", 1e-12);
  const auto udot = eom::udot(x, p);
  check("udot of u2, u1", udot, Eigen::Vector2d{9.398802832788292, -0.3510022843312933});

  // The multiplier of q1^2 + q2^2 == L^2 acts along (2 q1, 2 q2).
  const double squared_speed = x[u1] * x[u1] + x[u2] * x[u2];
  check("pull of the string", 2 * p[L] * eom::multipliers(x, p)(0),
        -p[m] * (squared_speed + p[g] * x[q1]) / p[L]);
  check("kinetic energy", eom::kinetic_energy(x, p), 3.021112809760348);
  check("potential energy", eom::potential_energy(x, p), -6.553419063257315);
  return check.exit_code();
}
