// builds: g++
#include "systems/check_robot_against_oracle.hpp"

#include <models/quadruped.hpp>

namespace {

static_assert(check::robot_cost<quadruped::System>() <= 3040); // including q̇ of the base

TEST(quadruped, agrees_with_the_oracle) {
  check::robot_against_oracle<quadruped::System>("quadruped_anymal", check::floating_base);
}

} // namespace
