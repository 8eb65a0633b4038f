// Andrews' squeezing mechanism at the start of its motion, with the published data.
#include "print.hpp"

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

  const auto udot = eom::udot(x);
  if (!udot.status) return 1;
  print("accelerations", udot);
  print("forces in the loops", -eom::multipliers(x));
}
