// builds: g++
#include "systems/check_against_oracle.hpp"

#include <models/arm3.hpp>

namespace {

using system = arm3::System;

TEST(arm3, agrees_with_the_oracle) { check::against_oracle<system>("arm3_spatial"); }
TEST(arm3, energy_rate_is_power) { check::energy_rate_is_power<system>("arm3_spatial"); }

} // namespace
