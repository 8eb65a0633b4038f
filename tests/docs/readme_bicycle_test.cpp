// The bicycle of the README, docs/guide/linearization.md and docs/simulation.md.
#include <kanexpr/assemble.hpp>
#include <kanexpr/operating_point.hpp>
#include <kanexpr/simulate.hpp>

#include <pictures/bicycle.hpp>

#include <Eigen/Eigenvalues>

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

namespace {

using namespace kanexpr;

TEST(readme, linearizes_a_bicycle) {
  const state<bicycle::BoundSystem> x;
  const parameter_values<bicycle::BoundSystem> p;
  const input_values<bicycle::BoundSystem> r;
#include <README/linearized.cpp>
  EXPECT_EQ(Ac.rows(), 6);
}

namespace stability {

using bicycle::BoundSystem;

state<BoundSystem> straight_ahead(double v) {
  state<BoundSystem> x;
  x[bicycle::u3] = v / 0.3;
  assemble<BoundSystem>(x);
  return x;
}

#include <docs/guide/linearization/stability.cpp>

TEST(linearization, is_stable_between_two_speeds) {
  const auto most = [](double v) { return lean_and_steer(v).eigenvalues().real().maxCoeff(); };
  EXPECT_GT(most(4.2923), 0);
  EXPECT_LT(most(4.2924), 0);
  EXPECT_LT(most(6.0242), 0);
  EXPECT_GT(most(6.0243), 0);
}

} // namespace stability

TEST(readme, simulates_a_bicycle) {
#include <README/simulated.cpp>
  ASSERT_TRUE(run) << run.cause();
#include <README/read.cpp>
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
