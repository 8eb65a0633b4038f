// builds: g++
#include "systems/check_robot_against_oracle.hpp"

#include <models/puma.hpp>

namespace {

using system = puma::System;

static_assert(check::robot_cost<system>() <= 900);

TEST(puma, agrees_with_the_oracle) { check::robot_against_oracle<system>("arm_puma_full"); }
TEST(puma, motors_bring_the_energy) { check::motors_bring_the_energy<system>("arm_puma_full"); }

} // namespace
