// The derivatives of a step against complex steps through the step itself.
#include "compiled/complex_steps.hpp"
#include "quaternions.hpp"
#include "runtime/four_bars.hpp"

#include <kanexpr/steps/linearized_step.hpp>
#include <models/double_pendulum.hpp>
#include <models/rotating_tube.hpp>

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using kanexpr::runge_kutta_4;
using kanexpr::semi_implicit_euler;

// [∂x⁺/∂x ∂x⁺/∂r] of a step.
template <class Step, class System>
MatrixXd by_complex_steps(const steps::point<System>& at, double h) {
  using complex = std::complex<double>;
  constexpr double tiny = 1e-30;
  const Eigen::Index n = at.x.size(), inputs = at.r.size();
  MatrixXd all(n, n + inputs);
  for (Eigen::Index j = 0; j < n + inputs; ++j) {
    kanexpr::state<System, complex> x(at.x.template cast<complex>());
    kanexpr::input_values<System, complex> r(at.r.template cast<complex>());
    (j < n ? x(j) : r(j - n)) += complex(0, tiny);
    double t = at.t;
    EXPECT_TRUE(Step{}(t, x, h, at.p, r));
    all.col(j) = x.imag() / tiny;
  }
  return all;
}

template <class Step, class System>
void expect_derivatives(const steps::point<System>& around, double reach, double h) {
  std::mt19937_64 source(3);
  int compared = 0;
  for (int tried = 0; compared < 10 && tried < 100; ++tried) {
    steps::point<System> at = steps::random_point(source, around, reach);
    if (!kanexpr::assemble<System>(at.x, at.p, at.r, at.t)) continue;
    double t = at.t;
    kanexpr::state<System> x = at.x;
    if (!Step{}(t, x, h, at.p, at.r)) continue;
    const auto next = [&] {
      no_heap::guard guard;
      return kanexpr::linearized<Step>{}(at.t, at.x, h, at.p, at.r);
    }();
    ASSERT_TRUE(next.status) << next.status.cause();
    EXPECT_LE((next.state - x).norm(), 1e-13 * x.norm());
    const MatrixXd expected = by_complex_steps<Step>(at, h);
    if (expected.norm() > 1e4) continue; // nearly singular
    EXPECT_LE((next.by_state - expected.leftCols(x.size())).norm(), 1e-11 * expected.norm());
    EXPECT_LE((next.by_inputs - expected.rightCols(at.r.size())).norm(), 1e-11 * expected.norm());
    ++compared;
  }
  EXPECT_EQ(compared, 10);
}

template <class System, int corrections = 1>
void both(const steps::point<System>& around = steps::plain_point<System>(), double reach = 1,
          double h = 0.01) {
  expect_derivatives<runge_kutta_4<System, corrections>>(around, reach, h);
  expect_derivatives<semi_implicit_euler<System, corrections>>(around, reach, h);
}

TEST(linearized_step, of_unconstrained_systems) {
  both<double_pendulum::System>();
  both<rotating_tube::System>();
}

TEST(linearized_step, carries_the_corrections_of_constraints) {
  using System = four_bars::System;
  const four_bars closed;
  steps::point<System> at{0, closed.x, closed.p, closed.r};
  both<System>(at, 0.1);
  both<System, 0>(at, 0.1);
  both<System, 2>(at, 0.1);
}

// Their norms are not 1 within a step, and are after it.
TEST(linearized_step, carries_the_norms_of_quaternions) {
  steps::point<quaternions::Two> two;
  two.x << 1, 1, 0, 0, 0, 0, 0, 0, 0.3, 1, -0.4, 0.7, -0.2, 0.5;
  both<quaternions::Two>(two, 0.3);
  both<quaternions::Two, 0>(two, 0.3);
  steps::point<quaternions::Sliding> sliding;
  sliding.x << 1, 0.1, 0.2, 0.05, 0.3, 0.2, -0.4;
  sliding.p << -0.2;
  both<quaternions::Sliding>(sliding, 0.1);
}

TEST(linearized_step, tells_what_a_step_tells) {
  using System = double_pendulum::System;
  steps::point<System> at = steps::plain_point<System>();
  at.p[double_pendulum::m2] = std::numeric_limits<double>::quiet_NaN();
  double t = 0;
  kanexpr::state<System> x = at.x;
  const auto made = runge_kutta_4<System>{}(t, x, 0.01, at.p, at.r);
  const auto next = kanexpr::linearized<runge_kutta_4<System>>{}(0, at.x, 0.01, at.p, at.r);
  EXPECT_FALSE(made);
  EXPECT_EQ(next.status.cause(), made.cause());
}

} // namespace
