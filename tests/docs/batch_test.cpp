// builds: clang++
// Many systems in parallel: docs/guide/batch.md.
#include <kanexpr/batch.hpp>
#include <kanexpr/kanexpr.hpp>
#include <models/double_pendulum.hpp>

#include <gtest/gtest.h>

#include <execution>
#include <iostream>
#include <thread>

namespace {

using namespace double_pendulum;
using eom = equations_of_motion<System>;

const eom::parameters arm{{m1, 1.1},  {m2, 0.6},  {d1, 0.4}, {d2, 0.35}, {l1, 0.9},
                          {I1, 0.07}, {I2, 0.02}, {g, 9.81}, {c1, 0.03}, {c2, 0.02}};

TEST(batch, is_an_array_of_systems) {
  const eom::inputs r(0.1, 0);
#include <docs/guide/batch/many.cpp>
  EXPECT_EQ(x.get(17), Eigen::Vector4d(0.3, 0.1, 5, 0));
  EXPECT_EQ(p.get(999)[m2], 0.8);
  {
#include <docs/guide/batch/results.cpp>
    EXPECT_TRUE(s);
    EXPECT_EQ(of_one, eom::udot(x.get(17), p.get(17), r));
    EXPECT_EQ(both.result<0>()(0, 1)(3), eom::mass_matrix(x.get(3), p.get(3), r)(0, 1));
    EXPECT_EQ(both.result<1>()(0)(3), eom::forcing(x.get(3), p.get(3), r)(0));
    p[I1](7) = p[m1](7) = p[m2](7) = 0;
#include <docs/guide/batch/status.cpp>
    EXPECT_EQ(udot.failures(), 1);
  }
  p[I1] = 0.07, p[m1] = 1.1, p[m2] = 0.6;
  many_results udot(eom::udot, 1000), expected(eom::udot, 1000);
  EXPECT_TRUE(expected.evaluate(x, p, r));
#include <docs/guide/batch/policy.cpp>
  EXPECT_TRUE((udot(0) == expected(0)).all() && (udot(1) == expected(1)).all());
#include <docs/guide/batch/threads.cpp>
  EXPECT_TRUE((udot(0) == expected(0)).all() && (udot(1) == expected(1)).all());
}

TEST(batch, is_rolled_out) {
  many<eom::state> x(1000);
  const eom::parameters& p = arm;
#include <docs/guide/batch/rollout.cpp>
  EXPECT_TRUE(arrived);
  double t = 0;
  eom::state own;
  for (int i = 0; i < 50; ++i) EXPECT_TRUE(runge_kutta_4<System>{}(t, own, 1e-3, p, law));
  EXPECT_EQ(ahead.stored(0).get(999), own);
}

TEST(batch, is_side_by_side) {
#include <docs/guide/batch/batch.cpp>
  EXPECT_EQ(of_second, eom::mass_matrix(eom::state(0.1, 0.7, 2, 3), arm));
}

} // namespace
