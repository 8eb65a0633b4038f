// A four-bar linkage that is assembled from a rough guess and then driven by its motor.
#include "print.hpp"

#include <kanexpr/steps/assemble.hpp>
#include <models/four_bar.hpp>

int main() {
  using namespace four_bar;
  using eom = kanexpr::equations_of_motion<System>;

  eom::parameters p;
  p[l0] = 1.0;
  p[l1] = 0.4;
  p[l2] = 1.1;
  p[l3] = 0.8;
  p[d1] = 0.15;
  p[d2] = 0.6;
  p[d3] = 0.35;
  p[m1] = 0.5;
  p[m2] = 1.2;
  p[m3] = 0.9;
  p[I1] = 0.011;
  p[I2] = 0.13;
  p[I3] = 0.05;
  p[g] = 9.81;

  eom::inputs r;
  r[T] = 0.909558;

  // The angle of the crank is given; the other angles need only be approximate.
  eom::state x;
  x[q1] = -2.266942;
  x[q2] = 3;
  x[q3] = -1.5;
  x[u1] = -1.959448;
  const auto assembled = kanexpr::assemble<System>(x, p, r);
  if (!assembled) return 1;

  print("angles", x.q());
  print("speeds", x.u());
  const auto udot = eom::udot(x, p, r);
  if (!udot.status) return 1;
  print("udot", udot);
  print("kinetic energy", eom::kinetic_energy(x, p, r));
}
