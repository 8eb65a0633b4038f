// builds: g++
#include "derivatives_of_steps.hpp"
#include "runtime/four_bars.hpp"

#include <kanexpr/steps/second_order_step.hpp>
#include <models/pendulum_nonminimal.hpp>

#include <cmath>

namespace {

using kanexpr::runge_kutta_4;
using kanexpr::semi_implicit_euler;
using step_checks::expect_derivatives;

TEST(linearized_step, carries_the_corrections_of_constraints) {
  using System = four_bars::System;
  const four_bars closed;
  const step_checks::point<System> at{0, closed.x, closed.p, closed.r};
  expect_derivatives<runge_kutta_4<System>>(at, 0.1);
  expect_derivatives<semi_implicit_euler<System>>(at, 0.1);
  expect_derivatives<semi_implicit_euler<System, 0>>(at, 0.1);
  expect_derivatives<semi_implicit_euler<System, 2>>(at, 0.1);
}

// A bob on a circle that crosses the point where the circle cannot be solved for the dependent coordinate.
template <class Step>
void expect_a_refusal(auto linearized_or_second) {
  using namespace pendulum_nonminimal;
  const kanexpr::parameter_values<System> p{{m, 1}, {L, 1}, {g, 9.81}};
  kanexpr::state<System> x{{q1, -1e-3}, {q2, std::sqrt(1 - 1e-6)}, {u1, 0}, {u2, 3e-3}};
  ASSERT_TRUE(kanexpr::assemble<System>(x, p));
  EXPECT_EQ(linearized_or_second(x, 1e-4, p), "");
  double t = 0;
  kanexpr::state<System> same = x;
  const kanexpr::status plain = Step{}(t, same, 1e-3, p);
  EXPECT_EQ(
      plain.cause(),
      "the step passes through or comes close to a position where the constraints cannot be solved for the "
      "dependent speeds: use passing<...>, or a different dependent<...> if only this choice is singular");
  EXPECT_EQ(linearized_or_second(x, 1e-3, p), plain.cause());
}

TEST(linearized_step, refuses_what_the_step_refuses) {
  using System = pendulum_nonminimal::System;
  const auto by = [](auto step) {
    return [](const kanexpr::state<System>& x, double h, const auto& p) {
      return kanexpr::linearized<decltype(step)>{}(0, x, h, p).status.cause();
    };
  };
  expect_a_refusal<runge_kutta_4<System>>(by(runge_kutta_4<System>{}));
  expect_a_refusal<semi_implicit_euler<System>>(by(semi_implicit_euler<System>{}));
}

TEST(second_order_step, refuses_what_the_step_refuses) {
  using System = pendulum_nonminimal::System;
  using step = runge_kutta_4<System, 0>;
  using second = kanexpr::second_order_step<step>;
  const kanexpr::input_values<System> none;
  const Eigen::Vector4d w(1, 2, 3, 4);
  expect_a_refusal<step>([&](const kanexpr::state<System>& x, double h, const auto& p) {
    return second::hessian(0, x, h, p, none, w).status.cause();
  });
  expect_a_refusal<step>([&](const kanexpr::state<System>& x, double h, const auto& p) {
    return second::hessian_product(0, x, h, p, none, w, w).status.cause();
  });
}

} // namespace
