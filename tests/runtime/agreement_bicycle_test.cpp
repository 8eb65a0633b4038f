// builds: g++
// The bicycle with symbols as parameters: results of the compiler and of the interpreter are identical, and
// its equations agree with the oracle.
#include "runtime/agreement.hpp"
#include "systems/check_constrained.hpp"

#include <models/bicycle.hpp>

namespace {

using system = bicycle::System;
using lin = kanexpr::linearization<system>;

constexpr kanexpr::symbolic::cost cost = lin::cost(lin::explicit_form);
static_assert(cost.multiplications + cost.additions <= 3509);

TEST(bicycle, agrees_with_the_oracle_where_its_parameters_are_symbols) {
  check::constrained_against_oracle<system>("bicycle_whipple");
}

TEST(agreement, bicycle) { agreement::check_rhs<system>(); }

TEST(agreement, linearization_of_bicycle) {
  using kanexpr::mechanics::quantity;
  auto derived = kanexpr::derive<system>();
  auto A = derived.function(derived.get(quantity::state_matrix));
  std::mt19937_64 source(7);
  for (int round = 0; round < 50; ++round) {
    const auto x = agreement::random<lin::state>(source, -3, 3);
    const auto p = agreement::random<lin::parameters>(source, 0.5, 2);
    const auto [a, b] = lin::explicit_form(x, p);
    agreement::expect_same_bits(a, A(x, p));
    EXPECT_EQ(b.cols(), 0);
  }
}

} // namespace
