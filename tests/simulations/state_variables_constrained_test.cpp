// builds: clang++ all
// A filter in a linkage, simulated through singular positions.
#include "steps/double_four_bar.hpp"

#include <kanexpr/simulate.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace {

/// A filter in a linkage that passes positions in which its constraints depend on each other.
namespace filter_in_a_linkage {

using namespace kanexpr;

constexpr state_variable<"z"> z;
struct System : extended<double_four_bar::System, states<z>, dynamics<0.3 * dot(z) == 2 - z>> {};

} // namespace filter_in_a_linkage

// Projections onto the constraints and the equations for all speeds leave the filter as it is.
template <kanexpr::integrator by>
void filters_in_a_linkage() {
  using linkage = filter_in_a_linkage::System;
  kanexpr::state<linkage> x = kanexpr::state<linkage>::Zero();
  x.head<10>() = double_four_bar::upright();
  const auto run = kanexpr::simulate<linkage, by>(x, {}, {0, 2}, {.relative_tolerance = 1e-9});
  ASSERT_TRUE(run) << run.cause();
  for (const auto& sample : run.trajectory)
    EXPECT_NEAR(sample.x[filter_in_a_linkage::z], 2 - 2 * std::exp(-sample.t / 0.3), 1e-7);
}

TEST(simulated_state_variables, pass_singular_positions) {
  filters_in_a_linkage<kanexpr::integrator::adams>();
  filters_in_a_linkage<kanexpr::integrator::differential_algebraic>();
}

} // namespace
