// A four-bar linkage: put together from a rough guess, then moved by its motor.
#include "report.hpp"

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

  // The crank is where it is; the other angles need only be near.
  eom::state x;
  x[q1] = -2.266942;
  x[q2] = 3;
  x[q3] = -1.5;
  x[u1] = -1.959448;
  const auto assembled = kanexpr::assemble<System>(x, p, r);
  if (!assembled) return 1;

  report check("four_bar", 1e-11);
  check("angles", x.q(), Eigen::Vector3d{-2.266942, 3.1693712817507778, -1.6715279750318761});
  check("speeds", x.u(), Eigen::Vector3d{-1.959448, 1.2451960519310379, 0.6869014155862296});
  const auto udot = eom::udot(x, p, r);
  if (!udot.status) return 1;
  check("udot", udot, Eigen::Vector3d{36.061981034855634, -22.96804441671319, -13.814365349082301});
  check("kinetic energy", eom::kinetic_energy(x, p, r), 0.15182840449925902);
  return check.exit_code();
}
