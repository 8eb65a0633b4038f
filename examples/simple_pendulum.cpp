// A pendulum with friction and a motor.
#include "print.hpp"

#include <models/simple_pendulum.hpp>

int main() {
  using namespace simple_pendulum;
  using eom = kanexpr::equations_of_motion<System>;

  eom::state x;
  x[q] = -2.297357;
  x[u] = 3.474337;

  eom::parameters p;
  p[m] = 1.3;
  p[l] = 0.7;
  p[g] = 9.81;
  p[c] = 0.05;

  eom::inputs inputs;
  inputs[T] = 1.055098;

  print("mass matrix", eom::mass_matrix(x, p).value());
  print("forcing", eom::forcing(x, p, inputs).value());
  print("udot", eom::udot(x, p, inputs).value());
  print("kinetic energy", eom::kinetic_energy(x, p));
  print("potential energy", eom::potential_energy(x, p));
}
