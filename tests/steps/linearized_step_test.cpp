// builds: clang++
#include "derivatives_of_steps.hpp"

#include <models/double_pendulum.hpp>
#include <models/rotating_tube.hpp>

namespace {

using kanexpr::runge_kutta_4;
using kanexpr::semi_implicit_euler;
using step_checks::expect_derivatives;

TEST(linearized_step, of_unconstrained_systems) {
  expect_derivatives<runge_kutta_4<double_pendulum::System>, double_pendulum::System>();
  expect_derivatives<kanexpr::ralston_3<double_pendulum::System>, double_pendulum::System>();
  expect_derivatives<semi_implicit_euler<rotating_tube::System>, rotating_tube::System>();
}

TEST(linearized_step, tells_what_a_step_tells) {
  using System = double_pendulum::System;
  step_checks::point<System> at = step_checks::plain_point<System>();
  at.p[double_pendulum::m2] = std::numeric_limits<double>::quiet_NaN();
  double t = 0;
  kanexpr::state<System> x = at.x;
  const auto made = runge_kutta_4<System>{}(t, x, 0.01, at.p, at.r);
  const auto next = kanexpr::linearized<runge_kutta_4<System>>{}(0, at.x, 0.01, at.p, at.r);
  EXPECT_FALSE(made);
  EXPECT_EQ(next.status.cause(), made.cause());
}

} // namespace
