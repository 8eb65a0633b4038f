// Compares the derivatives of a step with complex-step differentiation of the step.
#pragma once

#include "compiled/complex_steps.hpp"

#include <kanexpr/steps/linearized_step.hpp>

namespace step_checks {

// [∂x⁺/∂x ∂x⁺/∂r] of a step.
template <class Step, class System>
MatrixXd by_complex_steps(const point<System>& at, double h) {
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

// Compares them at random states that satisfy the constraints.
template <class Step, class System>
void expect_derivatives(const point<System>& around = plain_point<System>(), double reach = 1,
                        double h = 0.01) {
  std::mt19937_64 source(3);
  int compared = 0;
  for (int tried = 0; compared < 10 && tried < 100; ++tried) {
    point<System> at = random_point(source, around, reach);
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

} // namespace step_checks
