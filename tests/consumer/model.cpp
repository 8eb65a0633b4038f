#include "pendulum.hpp"

#include <cmath>

static_assert(KANEXPR_VERSION ==
              10000 * KANEXPR_VERSION_MAJOR + 100 * KANEXPR_VERSION_MINOR + KANEXPR_VERSION_PATCH);

int main() {
  using eom = kanexpr::equations_of_motion<pendulum::System>;
  eom::state x;
  x[pendulum::q] = 0.5, x[pendulum::u] = 0;
  eom::parameters p;
  p[pendulum::l] = 2;
  return std::abs(eom::udot(x, p)(0) + 9.81 / 2 * std::sin(0.5)) < 1e-15 ? 0 : 1;
}
