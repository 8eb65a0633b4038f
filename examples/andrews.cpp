// Andrews' squeezing mechanism at the start of its motion, as it is published.
#include "report.hpp"

#include <models/andrews.hpp>

int main() {
  using namespace andrews;
  using eom = kanexpr::equations_of_motion<System>;

  eom::state x;
  x[be] = -0.0617138900142764496;
  x[th] = 0;
  x[ga] = 0.455279819163070380;
  x[ph] = 0.222668390165885884;
  x[de] = 0.487364979543842550;
  x[om] = -0.222668390165885884;
  x[ep] = 1.23054744454982119;

  report check("andrews", 1e-10);
  const auto udot = eom::udot(x);
  if (!udot.status) return 1;
  check("accelerations", udot,
        Eigen::Vector<double, 7>{{14222.4439199541387, -10666.8329399655854, 0, 0, 0, 0, 0}});
  check("forces in the loops", -eom::multipliers(x),
        Eigen::Vector<double, 6>{{98.5668703962410896, -6.12268834425566265, 0, 0, 0, 0}});
  return check.exit_code();
}
