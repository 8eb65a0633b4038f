// builds: clang++
// The derivatives of the complete right-hand side of constrained systems with respect to the whole state.
#include "compiled/complex_steps.hpp"

#include <models/pendulum_nonminimal.hpp>
#include <models/rolling_disc_constrained.hpp>

namespace {

using step_checks::jacobian_is_that_of_rhs;

TEST(jacobian_of_constrained, pendulum_nonminimal) { jacobian_is_that_of_rhs<pendulum_nonminimal::System>(); }
TEST(jacobian_of_constrained, rolling_disc) { jacobian_is_that_of_rhs<rolling_disc_constrained::System>(); }

} // namespace
