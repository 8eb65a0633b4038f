// builds: g++
// Andrews' squeezing mechanism over 30 ms, in which its crank turns two and a half times.
#include "systems/andrews_reference.hpp"

#include <kanexpr/simulate.hpp>

#include <models/andrews.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace kanexpr;
using namespace andrews;

// Lioen & de Swart, Test Set for Initial Value Problem Solvers, "Andrews' squeezing mechanism".
const andrews_reference::vector7 end{{15.81077119629904, -15.75637105984298, 0.04082224013073101,
                                      -0.5347301163226948, 0.5244099658805304, 0.5347301163226948,
                                      1.048080741042263}};

state<System> start() {
  state<System> x;
  x.q() = andrews_reference::start;
  return x;
}

template <integrator by>
void ends_where_published(double tolerance) {
  const auto run = simulate<System, by>(start(), {}, {0, 0.03},
                                        {.relative_tolerance = tolerance, .absolute_tolerance = tolerance});
  ASSERT_TRUE(run) << run.cause();
  EXPECT_LT(((run.state.q() - end).array() / end.array()).abs().maxCoeff(), 1e-8);
  for (const auto& s : run.trajectory) {
    EXPECT_LE(equations_of_motion<System>::configuration_residual(s.x).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST(andrews, begins_with_the_published_accelerations) {
  const auto udot = equations_of_motion<System>::udot(start());
  ASSERT_TRUE(udot.status);
  EXPECT_LT((udot - andrews_reference::start_acceleration).cwiseAbs().maxCoeff(), 1e-12 * 14222);
}

TEST(andrews, ends_where_published_by_explicit_runge_kutta) {
  ends_where_published<integrator::explicit_runge_kutta>(1e-11);
}

TEST(andrews, ends_where_published_by_adams) { ends_where_published<integrator::adams>(1e-11); }

// Adams' formulas once restarted when they had drifted from the constraints. They then had low orders, which
// drift fastest: at small tolerances some simulations took a hundred times as many evaluations for a
// thousandth of the accuracy.
TEST(andrews, is_no_harder_for_adams_with_small_tolerances) {
  double tolerance = 1e-8;
  for (int i = 0; i <= 20; ++i, tolerance /= std::pow(10, 0.25)) {
    const auto run = simulate<System>(start(), {}, {0, 0.03},
                                      {.relative_tolerance = tolerance, .absolute_tolerance = tolerance});
    ASSERT_TRUE(run) << run.cause();
    EXPECT_LT((run.state.q() - end).cwiseAbs().maxCoeff(), 3000 * tolerance + 3e-9) << tolerance;
    EXPECT_LT(run.statistics.rate_evaluations, 3000) << tolerance;
  }
}

} // namespace
