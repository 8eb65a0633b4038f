// A spinning top whose speeds are not the rates of its angles.
#include "print.hpp"

#include <models/spinning_top.hpp>

int main() {
  using namespace spinning_top;
  using eom = kanexpr::equations_of_motion<System>;

  eom::state x;
  x[q1] = -2.193815;
  x[q2] = 2.418584;
  x[q3] = 1.582648;
  x[u1] = -2.44931;
  x[u2] = -0.045649;
  x[u3] = -6.061072;

  eom::parameters p;
  p[m] = 0.5;
  p[l] = 0.08;
  p[g] = 9.81;
  p[A] = 0.0009;
  p[C] = 0.0006;

  print("mass matrix", eom::mass_matrix(x, p));
  print("forcing", eom::forcing(x, p));
  print("udot", eom::udot(x, p));
  print("kinetic energy", eom::kinetic_energy(x, p));
  print("potential energy", eom::potential_energy(x, p));
}
