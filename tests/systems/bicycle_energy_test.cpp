// builds: g++
#include "systems/check_constrained.hpp"

#include <models/bicycle.hpp>

namespace {

using system = bicycle::BoundSystem;
using eom = kanexpr::equations_of_motion<system>;

// Rolling does no work.
TEST(bicycle, keeps_its_energy) {
  const auto hand = hand_written::bicycle(oracle::load("bicycle_whipple").parameters);
  std::mt19937 random(2);
  for (int repeat = 0; repeat < 20;) {
    const auto at = check::any_feasible(hand, check::VectorXd{{3, 1, 0.1, 1, 0, 0, 0, 0}}, 4, random);
    if (at.q.segment<3>(1).cwiseAbs().maxCoeff() > 1.1) continue; // upside down
    ++repeat;
    const check::VectorXd u = hand_written::solve(hand, at.q, at.qdot).speeds;
    const auto x = check::state_by_name<system>(hand.q, at.q, hand.u, u);
    const check::energy_rates energy = check::energy_rates_along<system>(x, check::without_heap(eom::rhs, x));
    EXPECT_NEAR(energy.kinetic, -energy.potential, 1e-10 * (1 + check::without_heap(eom::kinetic_energy, x)));
  }
}

} // namespace
