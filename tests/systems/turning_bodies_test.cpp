// builds: clang++
// Discs, a torus, a top and a body that turn in space.
#include "systems/check_against_oracle.hpp"

#include <models/pivot_body.hpp>
#include <models/rolling_disc.hpp>
#include <models/rolling_torus.hpp>
#include <models/spinning_top.hpp>

namespace {

TEST(rolling_disc, agrees_with_the_oracle) { check::against_oracle<rolling_disc::System>("rolling_disc"); }
TEST(rolling_disc, energy_rate_is_power) {
  check::energy_rate_is_power<rolling_disc::System>("rolling_disc");
}

TEST(rolling_torus, agrees_with_the_oracle) { check::against_oracle<rolling_torus::System>("rolling_torus"); }
TEST(rolling_torus, energy_rate_is_power) {
  check::energy_rate_is_power<rolling_torus::System>("rolling_torus");
}

TEST(spinning_top, agrees_with_the_oracle) { check::against_oracle<spinning_top::System>("spinning_top"); }
TEST(spinning_top, energy_rate_is_power) {
  check::energy_rate_is_power<spinning_top::System>("spinning_top");
}

TEST(pivot_body, agrees_with_the_oracle) {
  check::against_oracle<pivot_body::System>("quaternion_pivot_body");
}

// At the oracle's positions, whose quaternions have norm 1.
TEST(pivot_body, energy_rate_is_power) {
  using eom = kanexpr::equations_of_motion<pivot_body::System>;
  const oracle::system reference = oracle::load("quaternion_pivot_body");
  const auto p = check::parameters_of<pivot_body::System>(reference);
  for (const oracle::state& s : reference.states) {
    const auto x = check::stacked<pivot_body::System>(s.q, s.u);
    const auto rates = check::without_heap(eom::rhs, x, p, eom::inputs(s.r));
    const check::energy_rates energy = check::energy_rates_at<pivot_body::System>(x, p, rates);
    EXPECT_NEAR(energy.kinetic + energy.potential, s.r.dot(s.u), 1e-12 * s.r.norm() * s.u.norm());
  }
}

} // namespace
