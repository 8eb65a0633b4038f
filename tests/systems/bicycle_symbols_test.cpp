// builds: g++
#include "runtime/agreement.hpp"
#include "systems/check_constrained.hpp"

#include <models/bicycle.hpp>

namespace {

using system = bicycle::System;

TEST(bicycle, agrees_with_the_oracle_where_its_parameters_are_symbols) {
  check::constrained_against_oracle<system>("bicycle_whipple");
}

TEST(bicycle, compiled_and_interpreted_results_are_identical) { agreement::check_rhs<system>(); }

} // namespace
