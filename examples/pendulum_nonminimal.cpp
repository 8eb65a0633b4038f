// A pendulum described by the coordinates of its bob, with the tension of its string.
#include "print.hpp"

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

  const auto udot = eom::udot(x, p);
  print("udot of u2, u1", udot);

  // The multiplier of q1^2 + q2^2 == L^2 acts along (2 q1, 2 q2).
  print("pull of the string", 2 * p[L] * eom::multipliers(x, p)(0));
  print("kinetic energy", eom::kinetic_energy(x, p));
  print("potential energy", eom::potential_energy(x, p));
}
