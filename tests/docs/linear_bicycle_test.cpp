// builds: clang++ all
// The linearized bicycle of docs/tour.md and docs/guide/linearization.md.
#include <kanexpr/assemble.hpp>
#include <kanexpr/kanexpr.hpp>

#include <models/bicycle.hpp>

#include <Eigen/Eigenvalues>

#include <gtest/gtest.h>

namespace {

using namespace kanexpr;

TEST(tour, linearizes_a_bicycle) {
  const state<bicycle::BoundSystem> x;
  const parameter_values<bicycle::BoundSystem> p;
  const input_values<bicycle::BoundSystem> r;
#include <docs/tour/linearized.cpp>
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

} // namespace
