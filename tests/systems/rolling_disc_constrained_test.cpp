#include "systems/check_constrained.hpp"

#include <models/rolling_disc_constrained.hpp>

namespace {

using system = rolling_disc_constrained::System;

// The oracle does not include the position of the disc on the plane.
TEST(rolling_disc_constrained, agrees_with_the_oracle) {
  const oracle::system reference = oracle::load("rolling_disc");
  const auto p = check::parameters_by_name<system>(reference.parameters);
  const auto hand = hand_written::rolling_disc(reference.parameters);
  for (const oracle::state& s : reference.states) {
    check::VectorXd q = check::pick(hand.q, reference.q, s.q);
    q.tail<2>() << 3, -5;
    const check::feasible at{q, hand_written::rates_for(hand, q, reference.u, s.u)};
    const hand_written::solution expected = hand_written::solve(hand, at.q, at.qdot);
    EXPECT_TRUE(oracle::close(expected.udot.head<3>(), s.udot, 1e-12));
    check::against_hand_written<system>(hand, at, p, {}, 1e-12);
  }
}

TEST(rolling_disc_constrained, agrees_with_newton_and_euler_everywhere) {
  const check::numbers values = oracle::load("rolling_disc").parameters;
  const auto p = check::parameters_by_name<system>(values);
  const auto hand = hand_written::rolling_disc(values);
  std::mt19937 random(1);
  for (int repeat = 0; repeat < 20; ++repeat) {
    const auto at = check::any_feasible(hand, check::VectorXd{{3, 1.3, 3, 5, 5}}, 5, random);
    check::against_hand_written<system>(hand, at, p, {}, 1e-12);
    check::same_multipliers<system>(hand, at, p, {}, 1e-12);
    check::energy_rate_is_power_of<system>(hand, at, p, {});
  }
}

} // namespace
