// builds: clang++ all
// Fixed steps of systems with state variables: their accuracy, their derivatives, and singular positions.
#include "compiled/stirred_slider.hpp"
#include "derivatives_of_steps.hpp"
#include "steps/double_four_bar.hpp"

#include <kanexpr/fixed_step.hpp>
#include <models/motor_arm.hpp>

#include <cmath>

namespace {

/// An electrical filter in a linkage that passes singular positions.
namespace filter_in_a_linkage {

using namespace kanexpr;

constexpr state_variable<"z"> z;
struct System : extended<double_four_bar::System, states<z>, dynamics<0.3 * dot(z) == 2 - z>> {};

} // namespace filter_in_a_linkage

/// The error of a filtered step of the reference, 1 − e^(−t/τ), after four time constants.
template <class Step>
double error_of_filter(int steps) {
  using namespace motor_arm;
  kanexpr::parameter_values<System> p = kanexpr::parameter_values<System>::Ones();
  p[tau] = 0.25;
  const kanexpr::input_values<System> r{{reference, 1}};
  kanexpr::state<System> x;
  double t = 0;
  for (int k = 0; k < steps; ++k) EXPECT_TRUE(Step{}(t, x, 1.0 / steps, p, r));
  return std::abs(x[filtered] - (1 - std::exp(-4.0)));
}

TEST(steps_of_state_variables, have_the_order_of_the_method) {
  using motor_arm::System;
  const auto order = [](auto error) { return std::log2(error(64) / error(128)); };
  EXPECT_NEAR(order(error_of_filter<kanexpr::semi_implicit_euler<System>>), 1, 0.05);
  EXPECT_NEAR(order(error_of_filter<kanexpr::ralston_3<System>>), 3, 0.1);
  EXPECT_NEAR(order(error_of_filter<kanexpr::runge_kutta_4<System>>), 4, 0.1);
  EXPECT_LT(error_of_filter<kanexpr::runge_kutta_4<System>>(1000), 1e-12);
}

TEST(steps_of_state_variables, have_derivatives_with_constraints) {
  using stirred_slider::System;
  auto around = step_checks::plain_point<System>();
  around.x[stirred_slider::q] = 0.7;
  step_checks::expect_derivatives<kanexpr::runge_kutta_4<System>>(around, 0.2);
  step_checks::expect_derivatives<kanexpr::semi_implicit_euler<System>>(around, 0.2);
}

TEST(steps_of_state_variables, pass_singular_positions) {
  using namespace filter_in_a_linkage;
  using step = kanexpr::passing<kanexpr::runge_kutta_4<System>>;
  kanexpr::state<System> x = kanexpr::state<System>::Zero();
  x.head<10>() = double_four_bar::upright();
  const double energy = double_four_bar::energy(x(0), x(5));
  double t = 0;
  int passed = 0;
  for (int k = 0; k < 2000; ++k) {
    const double before = std::sin(x(0));
    ASSERT_TRUE(step{}(t, x, 1e-3));
    passed += before * std::sin(x(0)) < 0 ? 1 : 0;
    ASSERT_NEAR(x[z], 2 - 2 * std::exp(-t / 0.3), 1e-11);
  }
  EXPECT_GE(passed, 1);
  EXPECT_NEAR(double_four_bar::energy(x(0), x(5)), energy, 1e-6 * energy);
}

} // namespace
