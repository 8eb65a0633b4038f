// builds: clang++ all
// Regulators and filters of systems with state variables, and many such systems side by side.
#include <kanexpr/batch.hpp>
#include <kanexpr/control.hpp>
#include <kanexpr/fixed_step.hpp>
#include <models/motor_arm.hpp>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace motor_arm;
using step = kanexpr::runge_kutta_4<System>;

kanexpr::parameter_values<System> some_parameters() {
  return {{m, 2},   {l, 0.5},  {g, 9.81}, {n, 20},  {k, 0.05},
          {R, 0.8}, {L, 0.01}, {kp, 30},  {ki, 20}, {tau, 0.25}};
}

// The regulator moves every eigenvalue that the input can move.
TEST(control_of_state_variables, has_a_regulator) {
  using five = Eigen::Matrix<double, 5, 5>;
  const auto [A_, B_] = kanexpr::linearization<System>::explicit_form(
      kanexpr::state<System>(), some_parameters(), kanexpr::input_values<System>{{reference, 0}});
  const auto found = kanexpr::lqr(A_, B_, five::Identity().eval(), Eigen::Matrix<double, 1, 1>(1.0));
  ASSERT_TRUE(found.status) << found.status.cause();
  const five closed = A_ - B_ * found.K;
  EXPECT_LT(closed.eigenvalues().real().maxCoeff(), -0.1);
}

// From the angle, the filter finds the current, which it does not measure.
TEST(control_of_state_variables, is_observed_by_a_filter) {
  const kanexpr::parameter_values<System> p = some_parameters();
  const kanexpr::input_values<System> r{{reference, 1}};
  kanexpr::state<System> x;
  x[integral] = 0.3;
  using five = Eigen::Matrix<double, 5, 5>;
  kanexpr::ekf<System, q> filter(kanexpr::state<System>(), (0.1 * five::Identity()).eval());
  double t = 0;
  for (int made = 0; made < 3000; ++made) {
    ASSERT_TRUE(filter.predict(t, 1e-3, p, r, (1e-12 * five::Identity()).eval()));
    ASSERT_TRUE(step{}(t, x, 1e-3, p, r));
    ASSERT_TRUE(filter.update(Eigen::Matrix<double, 1, 1>(x[q]), p, r, Eigen::Matrix<double, 1, 1>(1e-8)));
  }
  EXPECT_NEAR(filter.x[i], x[i], 1e-4 * std::abs(x[i]));
  EXPECT_NEAR(filter.x[integral], x[integral], 1e-3);
}

// Many systems move like one, to the last bit.
TEST(control_of_state_variables, moves_side_by_side) {
  const kanexpr::parameter_values<System> p = some_parameters();
  const kanexpr::input_values<System> r{{reference, 1}};
  kanexpr::many<kanexpr::state<System>> x(5);
  for (Eigen::Index j = 0; j < 5; ++j) {
    kanexpr::state<System> start;
    start[i] = static_cast<double>(j);
    x.set(j, start);
  }
  const kanexpr::many<kanexpr::state<System>> start = x;
  kanexpr::rollout<step> ahead(5, {.step = 1e-3, .steps = 50});
  ASSERT_TRUE(ahead.run(x, p, r));
  for (Eigen::Index j = 0; j < 5; ++j) {
    kanexpr::state<System> own = start.get(j);
    double t = 0;
    for (int made = 0; made < 50; ++made) ASSERT_TRUE(step{}(t, own, 1e-3, p, r));
    EXPECT_EQ(x.get(j), own);
  }
}

} // namespace
