// builds: g++
#include "systems/check_constrained.hpp"

#include <models/bicycle.hpp>

namespace {

using system = bicycle::BoundSystem;

TEST(bicycle, agrees_with_the_oracle) { check::constrained_against_oracle<system>("bicycle_whipple"); }

// Leaning and steered by up to one radian, with both wheels on the ground.
TEST(bicycle, agrees_with_newton_and_euler_far_from_upright) {
  const auto hand = hand_written::bicycle(oracle::load("bicycle_whipple").parameters);
  std::mt19937 random(1);
  for (int repeat = 0; repeat < 20;) {
    const auto at = check::any_feasible(hand, check::VectorXd{{3, 1, 0.1, 1, 0, 0, 0, 0}}, 4, random);
    if (at.q.segment<3>(1).cwiseAbs().maxCoeff() > 1.1) continue; // upside down
    ++repeat;
    check::against_hand_written<system>(hand, at, {}, {}, 1e-11);
  }
}

} // namespace
