// builds: all
#include "runtime/agreement.hpp"
#include "systems/check_robot_against_oracle.hpp"

#include <models/iiwa.hpp>

namespace {

using system = iiwa::System;

static_assert(check::robot_cost<system>() <= 730);

TEST(iiwa, agrees_with_the_oracle) { check::robot_against_oracle<system>("arm_iiwa"); }
TEST(iiwa, motors_bring_the_energy) { check::motors_bring_the_energy<system>("arm_iiwa"); }
TEST(iiwa, compiled_and_interpreted_results_are_identical) { agreement::check<system>(); }

} // namespace
