// builds: clang++
#include "systems/check_constrained.hpp"

#include <models/chaplygin_sleigh.hpp>

namespace {

using namespace chaplygin_sleigh;
using eom = kanexpr::equations_of_motion<System>;

TEST(chaplygin_sleigh, agrees_with_the_oracle) {
  check::constrained_against_oracle<System>("chaplygin_sleigh");
}

TEST(chaplygin_sleigh, satisfies_its_constraints) { check::residuals_vanish<System>("chaplygin_sleigh"); }

TEST(chaplygin_sleigh, agrees_with_newton_and_euler_everywhere) {
  const check::numbers values = oracle::load("chaplygin_sleigh").parameters;
  const auto p = check::parameters_by_name<System>(values);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-3, 3);
  for (int repeat = 0; repeat < 20; ++repeat) {
    eom::inputs r;
    r[F] = any(random);
    r[T] = any(random);
    const auto hand = hand_written::chaplygin_sleigh(values, r[F], r[T]);
    const auto at = check::any_feasible(hand, check::VectorXd{{5, 5, 3}}, 4, random);
    check::against_hand_written<System>(hand, at, p, r, 1e-12);
    check::same_multipliers<System>(hand, at, p, r, 1e-12);
    check::energy_rate_is_power_of<System>(hand, at, p, r);
  }
}

} // namespace
