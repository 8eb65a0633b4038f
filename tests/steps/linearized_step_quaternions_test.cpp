// builds: clang++ all
#include "derivatives_of_steps.hpp"
#include "quaternions.hpp"

namespace {

using kanexpr::runge_kutta_4;
using kanexpr::semi_implicit_euler;
using step_checks::expect_derivatives;

// The norms differ from 1 within a step, but not after it.
TEST(linearized_step, carries_the_norms_of_quaternions) {
  using quaternions::Two, quaternions::Sliding;
  step_checks::point<Two> two;
  two.x << 1, 1, 0, 0, 0, 0, 0, 0, 0.3, 1, -0.4, 0.7, -0.2, 0.5;
  expect_derivatives<runge_kutta_4<Two>>(two, 0.3);
  step_checks::point<Sliding> sliding;
  sliding.x << 1, 0.1, 0.2, 0.05, 0.3, 0.2, -0.4;
  sliding.p << -0.2;
  expect_derivatives<semi_implicit_euler<Sliding>>(sliding, 0.1);
  expect_derivatives<semi_implicit_euler<Sliding, 0>>(sliding, 0.1);
}

} // namespace
