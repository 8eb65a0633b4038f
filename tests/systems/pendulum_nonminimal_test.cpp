// builds: clang++ sanitize
#include "systems/check_constrained.hpp"

#include <models/pendulum_nonminimal.hpp>

namespace {

using namespace pendulum_nonminimal;
using eom = kanexpr::equations_of_motion<System>;

TEST(pendulum_nonminimal, agrees_with_the_oracle) {
  check::constrained_against_oracle<System>("pendulum_nonminimal");
}

TEST(pendulum_nonminimal, satisfies_its_constraints) {
  check::residuals_vanish<System>("pendulum_nonminimal");
}

// At a position off the circle.
TEST(pendulum_nonminimal, tells_how_far_it_is_from_its_constraints) {
  eom::state x;
  x[q1] = 0.3;
  x[q2] = -0.6;
  x[u1] = 2;
  x[u2] = 0.5;
  eom::parameters p;
  p[m] = 1;
  p[L] = 0.7;
  p[g] = 9.81;
  EXPECT_NEAR(std::abs(check::without_heap(eom::configuration_residual, x, p)(0)), 0.04, 1e-15);
}

TEST(pendulum_nonminimal, agrees_with_newton_and_euler_everywhere) {
  const check::numbers values = oracle::load("pendulum_nonminimal").parameters;
  const auto p = check::parameters_by_name<System>(values);
  const auto hand = hand_written::pendulum_nonminimal(values);
  std::mt19937 random(1);
  for (int repeat = 0; repeat < 20;) {
    const auto at = check::any_feasible(hand, check::VectorXd{{1, 1}}, 4, random);
    if (std::abs(at.q(0)) < 0.1) continue; // level: q1 does not follow from q2
    ++repeat;
    check::against_hand_written<System>(hand, at, p, {}, 1e-11);
    check::same_multipliers<System>(hand, at, p, {}, 1e-11);
    check::energy_rate_is_power_of<System>(hand, at, p, {});
  }
}

// At a level position, q2 has its largest value, so its speed is zero and does not determine the other one.
TEST(pendulum_nonminimal, tells_where_it_cannot_be_solved) {
  const auto p = check::parameters_by_name<System>(oracle::load("pendulum_nonminimal").parameters);
  eom::state x;
  x[q2] = 0.7;
  x[u1] = 1;
  const auto udot = check::without_heap(eom::udot, x, p);
  EXPECT_FALSE(udot.status);
  EXPECT_FALSE(udot.status.cause().empty());
}

} // namespace
