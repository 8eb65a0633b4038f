#include "systems/check_constrained.hpp"

#include <models/four_bar.hpp>

namespace {

using namespace four_bar;
using eom = kanexpr::equations_of_motion<System>;

TEST(four_bar, agrees_with_the_oracle) { check::constrained_against_oracle<System>("four_bar"); }
TEST(four_bar, satisfies_its_constraints) { check::residuals_vanish<System>("four_bar"); }

// Away from positions in which coupler and rocker are in line: there the crank does not determine the other
// angles.
bool is_well_placed(const check::VectorXd& q) { return std::abs(std::sin(q(2))) > 0.2; }

TEST(four_bar, agrees_with_newton_and_euler_everywhere) {
  const check::numbers values = oracle::load("four_bar").parameters;
  const auto p = check::parameters_by_name<System>(values);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-3, 3);
  for (int repeat = 0; repeat < 20;) {
    eom::inputs r;
    r[T] = any(random);
    const auto hand = hand_written::four_bar(values, r[T]);
    const auto at = check::any_feasible(hand, check::VectorXd{{3, 3, 3}}, 4, random);
    if (!is_well_placed(at.q)) continue;
    ++repeat;
    check::against_hand_written<System>(hand, at, p, r, 1e-11);
    check::same_multipliers<System>(hand, at, p, r, 1e-11);
    check::energy_rate_is_power_of<System>(hand, at, p, r);
  }
}

// With coupler and rocker in line, the direction in which they buckle is undetermined.
TEST(four_bar, tells_where_it_cannot_be_solved) {
  const auto p = check::parameters_by_name<System>(oracle::load("four_bar").parameters);
  eom::state x;
  x[q1] = 0.3;
  x[q3] = 0;
  x[u1] = 1;
  const auto udot = check::without_heap(eom::udot, x, p, eom::inputs::Zero());
  EXPECT_FALSE(udot.status);
  EXPECT_FALSE(udot.status.cause().empty());
}

} // namespace
