// The rolling disc by equations of constraint: the same accelerations, and the friction that rolling takes.
#include "report.hpp"

#include <kanexpr/steps/assemble.hpp>
#include <models/rolling_disc_constrained.hpp>

int main() {
  using namespace rolling_disc_constrained;
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

  // The speed of the centre follows from rolling.
  if (!kanexpr::assemble<System>(x, p)) return 1;

  report check("rolling_disc_constrained", 1e-12);
  const auto udot = eom::udot(x, p);
  if (!udot.status) return 1;
  check("udot of the first three", udot.head<3>(),
        Eigen::Vector3d{12.896361274376956, -0.5278374085386667, 0.7293233304981176});
  check("kinetic energy", eom::kinetic_energy(x, p), 1.078580978185485);
  check("friction on the rim", eom::multipliers(x, p), p[m] * udot.tail<2>());
  return check.exit_code();
}
