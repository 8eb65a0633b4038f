// builds: g++
#include "systems/check_constrained.hpp"

#include <models/bicycle.hpp>

namespace {

TEST(bicycle, agrees_with_the_oracle_where_its_parameters_are_symbols) {
  check::constrained_against_oracle<bicycle::System>("bicycle_whipple");
}

} // namespace
