// builds: g++
#include "systems/check_constrained.hpp"

#include <kanexpr/steps/assemble.hpp>
#include <models/bicycle.hpp>

namespace {

using system = bicycle::BoundSystem;
using eom = kanexpr::equations_of_motion<system>;

TEST(bicycle, agrees_with_the_oracle) { check::constrained_against_oracle<system>("bicycle_whipple"); }
TEST(bicycle, satisfies_its_constraints) { check::residuals_vanish<system>("bicycle_whipple"); }

// Leaning and steered by up to one radian, with both wheels on the ground.
template <class Check>
void far_from_upright(unsigned seed, const Check& check_at) {
  const auto hand = hand_written::bicycle(oracle::load("bicycle_whipple").parameters);
  std::mt19937 random(seed);
  for (int repeat = 0; repeat < 20;) {
    const auto at = check::any_feasible(hand, check::VectorXd{{3, 1, 0.1, 1, 0, 0, 0, 0}}, 4, random);
    if (at.q.segment<3>(1).cwiseAbs().maxCoeff() > 1.1) continue; // upside down
    ++repeat;
    check_at(hand, at);
  }
}

TEST(bicycle, agrees_with_newton_and_euler_far_from_upright) {
  far_from_upright(1, [](const auto& hand, const auto& at) {
    check::against_hand_written<system>(hand, at, {}, {}, 1e-11);
  });
}

// Rolling does no work.
TEST(bicycle, keeps_its_energy) {
  far_from_upright(2, [](const auto& hand, const auto& at) {
    const check::VectorXd u = hand_written::solve(hand, at.q, at.qdot).speeds;
    const auto x = check::state_by_name<system>(hand.q, at.q, hand.u, u);
    const check::energy_rates energy = check::energy_rates_along<system>(x, check::without_heap(eom::rhs, x));
    EXPECT_NEAR(energy.kinetic, -energy.potential, 1e-10 * (1 + check::without_heap(eom::kinetic_energy, x)));
  });
}

// From an upright position, with nonzero values only for the independent speeds.
TEST(bicycle, is_assembled) {
  const oracle::system reference = oracle::load("bicycle_whipple");
  for (const oracle::state& s : reference.states) {
    const auto expected = check::state_by_name<system>(reference.q, s.q, reference.u, s.u);
    eom::state x = expected;
    x[bicycle::q4] = x[bicycle::u1] = x[bicycle::u4] = x[bicycle::u6] = 0;
    EXPECT_TRUE(kanexpr::assemble<system>(x));
    EXPECT_TRUE(oracle::close(x, expected, 1e-13));
  }
}

} // namespace
