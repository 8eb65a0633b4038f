// A torus that rolls without slipping; its contact point moves around the tube.
#include "print.hpp"

#include <models/rolling_torus.hpp>

int main() {
  using namespace rolling_torus;
  using eom = kanexpr::equations_of_motion<System>;

  eom::state x;
  x[q1] = -2.193815;
  x[q2] = 0.833841;
  x[q3] = 1.582648;
  x[u1] = -1.959448;
  x[u2] = -0.036519;
  x[u3] = -0.404071;

  eom::parameters p;
  p[R] = 0.5;
  p[a] = 0.12;
  p[m] = 3.1;
  p[g] = 9.81;

  print("udot", eom::udot(x, p));
  print("kinetic energy", eom::kinetic_energy(x, p));
  print("potential energy", eom::potential_energy(x, p));
}
