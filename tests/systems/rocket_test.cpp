#include "systems/check_constrained.hpp"

#include <models/rocket.hpp>

namespace {

using namespace rocket;

TEST(rocket, agrees_with_the_oracle) { check::constrained_against_oracle<System>("rocket_variable_mass"); }

} // namespace
