// A sleigh whose blade does not slip sideways. The constraint restricts the speeds but not the position.
#include "print.hpp"

#include <models/chaplygin_sleigh.hpp>

int main() {
  using namespace chaplygin_sleigh;
  using eom = kanexpr::equations_of_motion<System>;

  eom::state x;
  x[q1] = -2.193815;
  x[q2] = 2.084602;
  x[q3] = 1.582648;
  x[u1] = -1.469586;
  x[u2] = 0;
  x[u3] = -0.027389;

  eom::parameters p;
  p[m] = 1.7;
  p[I] = 0.21;
  p[a] = 0.33;

  eom::inputs r;
  r[F] = 1.51593;
  r[T] = 1.154893;

  // Two of the three speeds are independent; the multiplier is the force that keeps the blade on its track.
  print("mass matrix of u1 and u3", eom::mass_matrix(x, p, r));
  print("forcing", eom::forcing(x, p, r));
  print("udot of u1, u3, u2", eom::udot(x, p, r));
  print("qdot", eom::qdot(x, p, r));
  print("side force", eom::multipliers(x, p, r)(0));
}
