// builds: no-exceptions
// Fixed steps that satisfy the constraints.
#include "no_heap.hpp"
#include "runtime/four_bars.hpp"

#include <kanexpr/assemble.hpp>
#include <kanexpr/fixed_step.hpp>
#include <models/pendulum_nonminimal.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace {

using kanexpr::runge_kutta_4;
using kanexpr::semi_implicit_euler;
using kanexpr::status;

// A four-bar linkage that closes and is driven.
four_bars closed() {
  four_bars b;
  EXPECT_TRUE(kanexpr::assemble<four_bars::System>(b.x, b.p, b.r));
  return b;
}

template <class Step>
kanexpr::consistency after_many(Step step, four_bars& b, int steps, double h) {
  double now = 0;
  for (int i = 0; i < steps; ++i) {
    const status s = step(now, b.x, h, b.p, b.r);
    EXPECT_TRUE(s) << s.cause();
  }
  return kanexpr::check_consistency<four_bars::System>(b.x, b.p, b.r);
}

TEST(fixed_step, keeps_a_linkage_closed) {
  four_bars by_runge_kutta = closed(), by_euler = closed();
  const auto fourth = after_many(runge_kutta_4<four_bars::System>{}, by_runge_kutta, 10000, 1e-3);
  EXPECT_GT(by_runge_kutta.x[four_bar::q1], 20); // so its rounding error is 4e-15
  EXPECT_LT(fourth.configuration_residual, 1e-14);
  EXPECT_LT(fourth.velocity_residual, 1e-13);
  const auto first = after_many(semi_implicit_euler<four_bars::System>{}, by_euler, 10000, 1e-3);
  EXPECT_LT(first.configuration_residual, 1e-9);
  EXPECT_LT(first.velocity_residual, 1e-13);
}

TEST(fixed_step, takes_as_many_corrections_as_are_asked_for) {
  four_bars none = closed(), one = closed(), two = closed();
  const auto drifted = after_many(semi_implicit_euler<four_bars::System, 0>{}, none, 100, 5e-3);
  const auto after_one = after_many(semi_implicit_euler<four_bars::System, 1>{}, one, 100, 5e-3);
  const auto after_two = after_many(semi_implicit_euler<four_bars::System, 2>{}, two, 100, 5e-3);
  EXPECT_GT(drifted.configuration_residual, 1e-3);
  EXPECT_GT(drifted.velocity_residual, 1e-3);
  EXPECT_GT(after_one.configuration_residual, 1e-11);
  EXPECT_LT(after_one.configuration_residual, 1e-6);
  EXPECT_LT(after_two.configuration_residual, 1e-13);
  EXPECT_LT(after_two.velocity_residual, 1e-13);
}

// A pendulum on its circle hangs straight down after a quarter of its period.
template <class Step>
double error_of_pendulum(Step step, int steps) {
  using namespace pendulum_nonminimal;
  using eom = kanexpr::equations_of_motion<System>;
  eom::parameters p;
  p[m] = 1.3, p[L] = 0.7, p[g] = 9.81;
  const double start = 1.2, frequency = std::sqrt(p[g] / p[L]);
  const double quarter = std::comp_ellint_1(std::sin(start / 2)) / frequency;
  eom::state x;
  x[q1] = p[L] * std::cos(start), x[q2] = p[L] * std::sin(start);
  double now = 0;
  for (int i = 0; i < steps; ++i) {
    const status s = step(now, x, quarter / steps, p);
    EXPECT_TRUE(s) << s.cause();
  }
  eom::state exact;
  exact[q1] = p[L];
  exact[u2] = -2 * frequency * std::sin(start / 2) * p[L];
  return (x - exact).norm();
}

TEST(fixed_step, has_its_order_with_constraints) {
  using pendulum_nonminimal::System;
  const auto order_of = [](auto error_with, int steps) {
    return std::log2(error_with(steps) / error_with(2 * steps));
  };
  EXPECT_NEAR(order_of([](int n) { return error_of_pendulum(semi_implicit_euler<System>{}, n); }, 1000), 1,
              0.02);
  EXPECT_NEAR(order_of([](int n) { return error_of_pendulum(runge_kutta_4<System>{}, n); }, 50), 4, 0.15);
}

TEST(fixed_step, steps_a_linkage_in_single_precision) {
  using single = kanexpr::state<four_bars::System, float>;
  four_bars b = closed();
  single x = b.x.cast<float>();
  float now = 0;
  const kanexpr::parameter_values<four_bars::System, float> p = b.p.cast<float>();
  const kanexpr::input_values<four_bars::System, float> r = b.r.cast<float>();
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(runge_kutta_4<four_bars::System>{}(now, x, 1e-3f, p, r));
  after_many(runge_kutta_4<four_bars::System>{}, b, 100, 1e-3);
  EXPECT_LT((x.cast<double>() - b.x).norm(), 2e-5);
}

TEST(fixed_step, says_what_is_singular_and_leaves_the_state) {
  using namespace four_bar;
  four_bars b;
  b.p[l0] = 3.5, b.p[l1] = 0.75, b.p[l2] = 1.5, b.p[l3] = 1.25; // all bars in line
  b.x[q1] = b.x[q2] = b.x[q3] = 0;
  const auto before = b.x;
  double now = 2;
  for (const status& s : {runge_kutta_4<System>{}(now, b.x, 1e-3, b.p, b.r),
                          semi_implicit_euler<System>{}(now, b.x, 1e-3, b.p, b.r)}) {
    EXPECT_FALSE(s);
    EXPECT_EQ(s.cause(), "the constraints cannot be solved for the dependent speeds u2 and u3 at this state");
  }
  EXPECT_EQ(b.x, before);
  EXPECT_EQ(now, 2);
}

TEST(correction, says_what_cannot_be_solved_for) {
  four_bars b;
  b.x[four_bar::q3] = 0; // coupler and rocker in line
  const status two = kanexpr::steps::correction<four_bars::System, 1>::apply(0.0, b.x, b.p, b.r);
  EXPECT_EQ(two.cause(),
            "the constraints cannot be solved for the dependent coordinates q2 and q3 at this state");
  const status speeds = kanexpr::steps::correction<four_bars::System, 0>::apply(0.0, b.x, b.p, b.r);
  EXPECT_EQ(speeds.cause(),
            "the constraints cannot be solved for the dependent speeds u2 and u3 at this state");
  using circle = kanexpr::equations_of_motion<pendulum_nonminimal::System>;
  circle::state x;
  x[pendulum_nonminimal::q2] = 0.7; // and q1 = 0
  const status one = kanexpr::steps::correction<pendulum_nonminimal::System, 1>::apply(
      0.0, x, circle::parameters(1.3, 0.7, 9.81), circle::inputs::Zero());
  EXPECT_EQ(one.cause(), "the constraints cannot be solved for the dependent coordinate q1 at this state");
}

// A single unknown, whose pivot is compared with the other terms of its equation.
TEST(correction, says_it_in_whatever_units) {
  using namespace pendulum_nonminimal;
  using circle = kanexpr::equations_of_motion<System>;
  using kanexpr::steps::correction;
  for (const double length : {1e-12, 1e-6, 1.0, 1e6, 1e12}) {
    circle::parameters p;
    p[m] = 1.3, p[L] = length, p[g] = 9.81;
    circle::state x;
    x[q1] = 1e-15 * length, x[q2] = 1.0001 * length;
    EXPECT_EQ((correction<System, 1>::apply(0.0, x, p, circle::inputs::Zero()).cause()),
              "the constraints cannot be solved for the dependent coordinate q1 at this state");
    x[q1] = 1e-3 * length, x[q2] = length;
    EXPECT_TRUE((correction<System, 1>::apply(0.0, x, p, circle::inputs::Zero())));
  }
}

TEST(assemble, names_what_was_never_set) {
  four_bars b;
  const kanexpr::assembly none = kanexpr::assemble<four_bars::System>(b.x, {}, b.r);
  EXPECT_FALSE(none);
  EXPECT_EQ(none.cause(), "parameter m1 has no value");
  EXPECT_EQ(kanexpr::check_consistency<four_bars::System>(b.x, {}, b.r).cause(), "parameter m1 has no value");
  four_bars::eom::state x{{four_bar::u1, 5}};
  EXPECT_EQ(kanexpr::assemble<four_bars::System>(x, b.p).cause(), "coordinate q1 has no value");
}

TEST(assemble, does_not_blame_an_input_that_no_constraint_holds) {
  four_bars b = closed();
  EXPECT_TRUE(kanexpr::check_consistency<four_bars::System>(b.x, b.p));
  b.x[four_bar::q1] += 0.1;
  const auto off = kanexpr::check_consistency<four_bars::System>(b.x, b.p);
  EXPECT_TRUE(off.cause().starts_with("configuration constraint ")) << off.cause();
}

TEST(fixed_step, takes_no_memory_with_constraints) {
  four_bars b = closed();
  double now = 0;
  bool good = true;
  {
    no_heap::guard guard;
    const auto motor = [&](double t, const four_bars::eom::state&) {
      return four_bars::eom::inputs(0.3 * std::cos(t));
    };
    good = good && runge_kutta_4<four_bars::System>{}(now, b.x, 1e-3, b.p, motor);
    good = good && semi_implicit_euler<four_bars::System>{}(now, b.x, 1e-3, b.p, motor);
  }
  EXPECT_TRUE(good);
}

using eom = four_bars::eom;
constexpr auto plain = runge_kutta_4<four_bars::System, 0>::cost(),
               corrected = runge_kutta_4<four_bars::System>::cost(),
               corrected_twice = runge_kutta_4<four_bars::System, 2>::cost();
static_assert(plain.trigonometric ==
              4 * eom::cost(eom::rhs).trigonometric + 2 * eom::cost(eom::constraint_pivots).trigonometric);
static_assert(corrected.trigonometric > plain.trigonometric);
static_assert(corrected_twice.multiplications - corrected.multiplications <
              corrected.multiplications - plain.multiplications);    // the speeds are solved for once
static_assert(corrected_twice.divisions - corrected.divisions == 1); // by a determinant

} // namespace
