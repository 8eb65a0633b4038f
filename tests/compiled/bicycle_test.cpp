// builds: g++
// The bicycle: the derivatives of its complete right-hand side with respect to its whole state, at states in
// which its front wheel is off the ground and slips, and F_r + F_r* of all speeds.
#include "compiled/complex_steps.hpp"
#include "compiled/unreduced_forces.hpp"

#include <models/bicycle.hpp>

namespace {

using eom = kanexpr::equations_of_motion<bicycle::BoundSystem>;
using lin = kanexpr::linearization<bicycle::BoundSystem>;

constexpr kanexpr::symbolic::cost of_jacobian = lin::cost(lin::jacobian);
static_assert(of_jacobian.multiplications + of_jacobian.additions <= 4444);
constexpr kanexpr::symbolic::cost of_forces = eom::cost(eom::unreduced_forces);
static_assert(of_forces.multiplications + of_forces.additions <= 240);

TEST(jacobian_of_bicycle, is_that_of_rhs) {
  step_checks::jacobian_is_that_of_rhs<bicycle::BoundSystem>({}, 0.6);
}

TEST(unreduced_forces, bicycle) { forces::balance_and_reduce<bicycle::BoundSystem>(0.6); }

} // namespace
