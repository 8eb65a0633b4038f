// builds: g++
#include "derivatives_of_steps.hpp"
#include "runtime/four_bars.hpp"

namespace {

using kanexpr::runge_kutta_4;
using kanexpr::semi_implicit_euler;
using steps::expect_derivatives;

TEST(linearized_step, carries_the_corrections_of_constraints) {
  using System = four_bars::System;
  const four_bars closed;
  const steps::point<System> at{0, closed.x, closed.p, closed.r};
  expect_derivatives<runge_kutta_4<System>>(at, 0.1);
  expect_derivatives<semi_implicit_euler<System>>(at, 0.1);
  expect_derivatives<semi_implicit_euler<System, 0>>(at, 0.1);
  expect_derivatives<semi_implicit_euler<System, 2>>(at, 0.1);
}

} // namespace
