#include "systems/check_against_oracle.hpp"

#include <models/double_pendulum.hpp>

namespace {

using system = double_pendulum::System;

TEST(double_pendulum, agrees_with_the_oracle) { check::against_oracle<system>("double_pendulum"); }
TEST(double_pendulum, energy_rate_is_power) { check::energy_rate_is_power<system>("double_pendulum"); }

} // namespace
