// builds: clang++ sanitize
#include "systems/check_against_oracle.hpp"

#include <models/simple_pendulum.hpp>

namespace {

using system = simple_pendulum::System;

TEST(simple_pendulum, agrees_with_the_oracle) { check::against_oracle<system>("simple_pendulum"); }
TEST(simple_pendulum, energy_rate_is_power) { check::energy_rate_is_power<system>("simple_pendulum"); }

} // namespace
