// builds: clang++
// The arm with computed torques, compared with the same loop with recursive Newton-Euler equations in NumPy,
// and with the error that the gains are designed to produce.
#include "control/matrices.hpp"
#include "loops/references.hpp"
#include "no_heap.hpp"

#include <loops/computed_torque.hpp>

namespace {

using namespace computed_torque;
using references::close;
namespace known = references::arm;

const eom::state start(known::start);
const eom::parameters none;

TEST(computed_torque, moves_as_in_numpy) {
  loop<double> moving(start);
  no_heap::guard guard;
  for (int part = 0; part < 5; ++part) {
    for (int k = 0; k < 500; ++k) {
      const status made = moving.go_on();
      ASSERT_TRUE(made) << made.cause();
    }
    EXPECT_TRUE(close(moving.x, Eigen::Map<const Eigen::Vector<double, 14>>(known::states[part]), 1e-10));
    EXPECT_TRUE(close(moving.r, Eigen::Map<const Eigen::Vector<double, 7>>(known::torques[part]), 1e-10));
  }
}

// e'' + 20 e' + 100 e = 0.
joints<double> error_by_the_gains(double t) {
  const joints<double> e = start.q() - motion_at(0.0).angles, rate = start.u() - motion_at(0.0).speeds;
  return (e + t * (rate + 10 * e)) * std::exp(-10 * t);
}

// Torques that follow the state continuously, not once in each period.
TEST(computed_torque, lets_the_error_die_out_by_its_gains) {
  eom::state x = start;
  double t = 0;
  for (int k = 1; k <= 3000; ++k) {
    ASSERT_TRUE(runge_kutta_4<System>{}(t, x, 0.0005, none,
                                        [](double now, const eom::state& at) { return torques(now, at); }));
    if (k % 100 != 0) continue;
    const joints<double> off = x.q() - motion_at(t).angles - error_by_the_gains(t);
    EXPECT_LE(off.cwiseAbs().maxCoeff(), 1e-9) << t;
  }
}

// The greatest deviation from that error if torques are held for this period.
double lag_with(double h) {
  eom::state x = start;
  double most = 0;
  for (double t = 0; t < 1.5;) {
    const eom::inputs r = torques(t, x);
    EXPECT_TRUE(runge_kutta_4<System>{}(t, x, h, none, r));
    const joints<double> off = x.q() - motion_at(t).angles - error_by_the_gains(t);
    most = std::max(most, off.cwiseAbs().maxCoeff());
  }
  return most;
}

TEST(computed_torque, lags_in_proportion_to_the_period) {
  const double lag = lag_with(period), of_half = lag_with(period / 2), of_quarter = lag_with(period / 4);
  EXPECT_LT(lag, 2e-3);
  EXPECT_NEAR(lag / of_half, 2, 0.05);
  EXPECT_NEAR(of_half / of_quarter, 2, 0.025);
}

TEST(computed_torque, wants_a_smooth_motion) {
  EXPECT_EQ(motion_at(-1.0).angles, numeric::as_eigen(begin));
  EXPECT_TRUE(close(motion_at(9.0).angles, numeric::as_eigen(end), 1e-15));
  constexpr double h = 1e-4;
  for (double t = -0.25; t < 2.5; t += 0.125) {
    const auto before = motion_at(t - h), now = motion_at(t), after = motion_at(t + h);
    EXPECT_LE((after.angles - before.angles - 2 * h * now.speeds).norm(), 1e-10) << t;
    EXPECT_LE((after.speeds - before.speeds - 2 * h * now.accelerations).norm(), 2e-7) << t;
  }
}

TEST(computed_torque, keeps_to_its_path_in_single_precision) {
  loop<float> moving(start.cast<float>());
  while (moving.t < 3) {
    ASSERT_TRUE(moving.go_on());
    if (moving.t < 1) continue;
    EXPECT_LT(moving.error().cwiseAbs().maxCoeff(), 2e-3F) << moving.t;
  }
}

} // namespace
