#include "systems/check_against_oracle.hpp"

#include <models/pivot_body.hpp>

namespace {

using system = pivot_body::System;

TEST(pivot_body, agrees_with_the_oracle) { check::against_oracle<system>("quaternion_pivot_body"); }

// At the oracle's positions, whose quaternions have norm 1.
TEST(pivot_body, energy_rate_is_power) {
  using eom = kanexpr::equations_of_motion<system>;
  const oracle::system reference = oracle::load("quaternion_pivot_body");
  const auto p = check::parameters_of<system>(reference);
  for (const oracle::state& s : reference.states) {
    const auto x = check::stacked<system>(s.q, s.u);
    const auto rates = check::without_heap(eom::rhs, x, p, eom::inputs(s.r));
    const check::energy_rates energy = check::energy_rates_at<system>(x, p, rates);
    EXPECT_NEAR(energy.kinetic + energy.potential, s.r.dot(s.u), 1e-12 * s.r.norm() * s.u.norm());
  }
}

} // namespace
