// A disc that rolls without slipping: its generalized speeds are chosen such that they satisfy the constraint
// automatically.
#include "print.hpp"

#include <models/rolling_disc.hpp>

int main() {
  using namespace rolling_disc;
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

  print("mass matrix", eom::mass_matrix(x, p));
  print("forcing", eom::forcing(x, p));
  print("udot", eom::udot(x, p));
  print("kinetic energy", eom::kinetic_energy(x, p));
}
