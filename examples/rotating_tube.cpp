// A bead in a tube whose angle is prescribed.
#include "print.hpp"

#include <models/rotating_tube.hpp>

int main() {
  using namespace rotating_tube;
  using eom = kanexpr::equations_of_motion<System>;

  eom::state x;
  x[q] = -0.731272;
  x[u] = 2.084602;

  eom::parameters p;
  p[m] = 0.8;
  p[k] = 12.0;
  p[q0] = 0.5;
  p[g] = 9.81;
  p[c] = 0.1;

  eom::inputs r;
  r[theta] = 1.582648;
  r[dot(theta)] = -2.939172;
  r[dot(dot(theta))] = -0.045649;

  print("udot", eom::udot(x, p, r)(0));

  constexpr kanexpr::function<System, kanexpr::dot(kanexpr::acceleration_of<P>, A::y)> across;
  print("acceleration across the tube", across(x, p, r));
}
