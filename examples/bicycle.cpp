// A bicycle that leans and is steered: its pitch and three of its speeds follow from wheels that touch the
// ground and roll.
#include "report.hpp"

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

  report check("bicycle", 1e-11);
  check("pitch", x[q4], 0.005819781082092396);
  check("u1, u4, u6", x.u().tail<3>(),
        Eigen::Vector3d{-0.8194761804895839, 0.004043525578132023, 7.710030495640377});
  const auto udot = eom::udot(x);
  if (!udot.status) return 1;
  check("udot of u2, u3, u5, u1, u4, u6", udot,
        Eigen::Vector<double, 6>{{0.5603933912016607, 0.18699750100126994, 1.8917584218369776,
                                  -0.9079710500366327, 0.02941699788325535, 1.0832124052217722}});
  check("kinetic energy", eom::kinetic_energy(x), 278.3494928011807);
  check("potential energy", eom::potential_energy(x), 761.6711577886754);
  return check.exit_code();
}
