// A pendulum with friction and a motor.
#include "report.hpp"

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

  report check("simple_pendulum", 1e-12);
  check("mass matrix", eom::mass_matrix(x, p).value(), 0.6369999999999999);
  check("forcing", eom::forcing(x, p, inputs).value(), 7.554063213505138);
  check("udot", eom::udot(x, p, inputs).value(), 11.858811952127377);
  check("kinetic energy", eom::kinetic_energy(x, p), 3.8446191022777256);
  check("potential energy", eom::potential_energy(x, p), 5.93029750428904);
  return check.exit_code();
}
