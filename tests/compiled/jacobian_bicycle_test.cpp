// builds: g++
// The derivatives of a bicycle's complete right-hand side with respect to its whole state, at states in which
// its front wheel is off the ground and slips.
#include "compiled/complex_steps.hpp"

#include <models/bicycle.hpp>

namespace {

using lin = kanexpr::linearization<bicycle::BoundSystem>;

constexpr kanexpr::symbolic::cost cost = lin::cost(lin::jacobian);
static_assert(cost.multiplications + cost.additions <= 4444);

TEST(jacobian_of_bicycle, is_that_of_rhs) {
  step_checks::jacobian_is_that_of_rhs<bicycle::BoundSystem>({}, 0.6);
}

} // namespace
