// builds: clang++
// The derivatives of the complete right-hand side with respect to the whole state, for systems without
// constraints and for Lagrange's method.
#include "compiled/complex_steps.hpp"

#include <models/double_pendulum.hpp>
#include <models/four_bar.hpp>
#include <models/rotating_tube.hpp>
#include <models/simple_pendulum.hpp>

namespace {

using step_checks::jacobian_is_that_of_rhs;

TEST(jacobian, simple_pendulum) { jacobian_is_that_of_rhs<simple_pendulum::System>(); }
TEST(jacobian, double_pendulum) { jacobian_is_that_of_rhs<double_pendulum::System>(); }
TEST(jacobian, rotating_tube) { jacobian_is_that_of_rhs<rotating_tube::System>(); }
TEST(jacobian, rotating_tube_by_lagrange) { jacobian_is_that_of_rhs<rotating_tube::LagrangeSystem>(); }
TEST(jacobian, four_bar_by_lagrange) { jacobian_is_that_of_rhs<four_bar::LagrangeSystem>(); }

// Nothing is dependent, so the result equals the linearization and has the same cost.
using lin = kanexpr::linearization<double_pendulum::System>;
static_assert(lin::cost(lin::jacobian) == lin::cost(lin::explicit_form));

TEST(jacobian, is_the_linearization_without_constraints) {
  std::mt19937_64 source(3);
  const auto at = step_checks::random_point(source, step_checks::plain_point<double_pendulum::System>(), 3);
  const auto [A, B] = lin::explicit_form(at.x, at.p, at.r);
  const auto [by_state, by_inputs] = lin::jacobian(at.x, at.p, at.r);
  EXPECT_EQ(A, by_state);
  EXPECT_EQ(B, by_inputs);
}

} // namespace
