// A rocket that burns its mass; the mass and its rate are known functions of time.
#include "print.hpp"

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

  print("udot", eom::udot(x, p, r)(0));

  // In free flight, with the thrust of gas ejected at 3000 m/s, as in the rocket equation.
  p[cd] = 0;
  r[T] = (x[u] - 3000) * r[dot(m)];
  print("in free flight", eom::udot(x, p, r)(0));
}
