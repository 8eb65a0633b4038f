// builds: clang++ all
// F_r + F_r* of all speeds of a bicycle.
#include "compiled/unreduced_forces.hpp"

#include <models/bicycle.hpp>

namespace {

using eom = kanexpr::equations_of_motion<bicycle::BoundSystem>;

constexpr kanexpr::symbolic::cost cost = eom::cost(eom::unreduced_forces);
static_assert(cost.multiplications + cost.additions <= 240);

TEST(unreduced_forces, bicycle) { forces::balance_and_reduce<bicycle::BoundSystem>(0.6); }

} // namespace
