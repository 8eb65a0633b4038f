// The rolling disc with constraint equations: the same accelerations, and the friction force that rolling
// requires.
#include "print.hpp"

#include <kanexpr/steps/assemble.hpp>
#include <models/rolling_disc_constrained.hpp>

int main() {
  using namespace rolling_disc_constrained;
  using eom = kanexpr::equations_of_motion<System>;

  eom::state x;
  x[q1] = -2.193815;
  x[q2] = 0.833841;
  x[q3] = 1.582648;
  x[u1] = -1.959448;
  x[u2] = -0.036519;
  x[u3] = -0.404071;

  eom::parameters p;
  p[r] = 0.45;
  p[m] = 2.2;
  p[g] = 9.81;

  // The velocity of the center follows from rolling.
  if (!kanexpr::assemble<System>(x, p)) return 1;

  const auto udot = eom::udot(x, p);
  if (!udot.status) return 1;
  print("udot of the first three", udot.head<3>());
  print("kinetic energy", eom::kinetic_energy(x, p));
  print("friction on the rim", eom::multipliers(x, p));
}
