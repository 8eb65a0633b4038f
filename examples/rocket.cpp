// A rocket that burns its mass; the mass and its rate are known functions of time.
#include "report.hpp"

#include <models/rocket.hpp>

int main() {
  using namespace rocket;
  using eom = kanexpr::equations_of_motion<System>;

  eom::state x;
  x[q] = 13.436424;
  x[u] = 161.858434;

  eom::parameters p;
  p[g] = 9.81;
  p[cd] = 0.02;

  eom::inputs r;
  r[m] = 39.369858;
  r[dot(m)] = -2.234793;
  r[T] = 445.891578;

  report check("rocket", 1e-12);
  check("udot", eom::udot(x, p, r)(0), -2.6052846526519136);

  // In free flight, with a thrust that gas of 3000 m/s gives, u' is the rocket equation's 3000 m/s * -m'/m -
  // g.
  p[cd] = 0;
  r[T] = (x[u] - 3000) * r[dot(m)];
  check("Tsiolkovsky", eom::udot(x, p, r)(0), -3000 * r[dot(m)] / r[m] - p[g]);
  return check.exit_code();
}
