#include "systems/check_against_oracle.hpp"

#include <models/spinning_top.hpp>

namespace {

using system = spinning_top::System;

TEST(spinning_top, agrees_with_the_oracle) { check::against_oracle<system>("spinning_top"); }
TEST(spinning_top, energy_rate_is_power) { check::energy_rate_is_power<system>("spinning_top"); }

} // namespace
