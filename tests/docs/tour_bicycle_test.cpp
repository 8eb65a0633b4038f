// builds: clang++ all
// The motions of the bicycle in docs/tour.md and docs/simulation.md.
#include <kanexpr/operating_point.hpp>
#include <kanexpr/simulate.hpp>

#include <pictures/bicycle.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

namespace {

using namespace kanexpr;

TEST(tour, simulates_a_bicycle) {
#include <docs/tour/simulated.cpp>
  ASSERT_TRUE(run) << run.cause();
#include <docs/tour/read.cpp>
  EXPECT_NEAR(run.events[0].t, 0.8364, 5e-5);
  const auto lean = run.trajectory[q2];
  EXPECT_EQ(lean.size(), 501);
  EXPECT_NEAR(*std::max_element(lean.begin(), lean.end()), 0.0466, 5e-5);
}

TEST(operating_points, are_turns) {
#include <docs/simulation/turn.cpp>
  ASSERT_TRUE(turn) << turn.cause();
  EXPECT_NEAR(turn.x[u3], 19.6944, 5e-5);
  EXPECT_NEAR(turn.x[q5], 0.06016, 5e-6);
  EXPECT_NEAR(turn.x[u1], -0.3385, 5e-5);
  EXPECT_EQ(turn.freedom, 1);
}

} // namespace

#include <docs/simulation/page.cpp>
