// builds: g++
// Control: docs/guide/control.md.
#include <kanexpr/control.hpp>

#include <models/bicycle.hpp>
#include <models/simple_pendulum.hpp>

#include <gtest/gtest.h>

#include <iostream>
#include <numbers>

namespace {

using namespace kanexpr;

TEST(control, regulates_and_estimates) {
#include <docs/guide/control/regulator.cpp>
  ASSERT_TRUE(made);
  ASSERT_TRUE(continuous);
  ASSERT_TRUE(discrete);
  // A moment greater than that of the weight, m g l, turns it over.
  EXPECT_GT(continuous.K(0), 9.81 * 0.5);
  EXPECT_GT(continuous.K(1), 0);
  EXPECT_LT((discrete.K - continuous.K).norm(), 0.1 * continuous.K.norm());
  EXPECT_GT(r[T], 0);
#include <docs/guide/control/filter.cpp>
  EXPECT_GT(filter.x[q], 3);
  EXPECT_LT(filter.x[q], 3.01);
  EXPECT_LT(filter.P(0, 0), 1e-4);
}

namespace riding {

#include <docs/guide/control/schedule.cpp>

TEST(control, has_gains_of_the_compiler) {
#include <docs/guide/control/scheduled.cpp>
  EXPECT_TRUE(K.allFinite());
  EXPECT_EQ(K(0), gains(3.2)(0, 0));
}

} // namespace riding

} // namespace
