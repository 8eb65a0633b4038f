// builds: g++
// The derivatives of the whole right side of a bicycle by its whole state, where its front wheel is off the
// ground and slips.
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
