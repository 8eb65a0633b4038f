#include "systems/check_against_oracle.hpp"

#include <models/rolling_torus.hpp>

namespace {

using system = rolling_torus::System;

TEST(rolling_torus, agrees_with_the_oracle) { check::against_oracle<system>("rolling_torus"); }
TEST(rolling_torus, energy_rate_is_power) { check::energy_rate_is_power<system>("rolling_torus"); }

} // namespace
