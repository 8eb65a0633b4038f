// Two bars with friction and a motor at each joint.
#include "print.hpp"

#include <models/double_pendulum.hpp>

int main() {
  using namespace double_pendulum;
  using eom = kanexpr::equations_of_motion<System>;

  eom::state x;
  x[q1] = -2.297357;
  x[q2] = 2.182991;
  x[u1] = 2.110197;
  x[u2] = -1.959448;

  eom::parameters p;
  p[m1] = 1.1;
  p[m2] = 0.6;
  p[d1] = 0.4;
  p[d2] = 0.35;
  p[l1] = 0.9;
  p[I1] = 0.07;
  p[I2] = 0.02;
  p[g] = 9.81;
  p[c1] = 0.03;
  p[c2] = 0.02;

  eom::inputs inputs;
  inputs[T1] = -0.027389;
  inputs[T2] = -0.303054;

  print("mass matrix", eom::mass_matrix(x, p));
  print("forcing", eom::forcing(x, p, inputs));
  print("udot", eom::udot(x, p, inputs));
  print("kinetic energy", eom::kinetic_energy(x, p));
  print("potential energy", eom::potential_energy(x, p));
}
