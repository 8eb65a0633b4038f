// A bicycle that leans and is steered. Its pitch and three of its speeds follow from the constraints that the
// wheels touch the ground and roll without slipping.
#include "print.hpp"

#include <kanexpr/steps/assemble.hpp>
#include <models/bicycle.hpp>

int main() {
  using namespace bicycle;
  using eom = kanexpr::equations_of_motion<BoundSystem>;

  eom::state x;
  x[q1] = -2.193815;
  x[q2] = 0.277947;
  x[q5] = 0.31653;
  x[u2] = -0.00913;
  x[u3] = 8.484732;
  x[u5] = 0.303186;
  if (!kanexpr::assemble<BoundSystem>(x)) return 1;

  print("pitch", x[q4]);
  print("u1, u4, u6", x.u().tail<3>());
  const auto udot = eom::udot(x);
  if (!udot.status) return 1;
  print("udot of u2, u3, u5, u1, u4, u6", udot);
  print("kinetic energy", eom::kinetic_energy(x));
  print("potential energy", eom::potential_energy(x));
}
