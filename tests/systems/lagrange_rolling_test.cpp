// builds: g++
#include "systems/check_lagrange.hpp"

#include <models/rolling_disc_constrained.hpp>
#include <models/rolling_torus.hpp>

namespace {

TEST(lagrange, rolling_disc) {
  using namespace rolling_disc_constrained;
  const check::numbers values = oracle::load("rolling_disc").parameters;
  check::lagrange_against_kane<System, LagrangeSystem, false>(values, 1.3);
  check::keeps_its_energy<LagrangeSystem>(values, 1.3);
}

// In Kane's system the contact point is declared at rest; Lagrange's system has a constraint for this.
TEST(lagrange, rolling_torus) {
  using namespace rolling_torus;
  const check::numbers values = oracle::load("rolling_torus").parameters;
  check::lagrange_against_kane<System, LagrangeSystem, false>(values, 1.3);
  check::keeps_its_energy<LagrangeSystem>(values, 1.3);
}

} // namespace
