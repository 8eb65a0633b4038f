#include "systems/check_against_oracle.hpp"

#include <models/rolling_disc.hpp>

namespace {

using system = rolling_disc::System;

TEST(rolling_disc, agrees_with_the_oracle) { check::against_oracle<system>("rolling_disc"); }
TEST(rolling_disc, energy_rate_is_power) { check::energy_rate_is_power<system>("rolling_disc"); }

} // namespace
