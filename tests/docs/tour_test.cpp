// builds: clang++
// docs/tour.md, except for the bicycle and the robots.
#include "docs/printed.hpp"
#include "docs/text.hpp"
#include "models/four_bar.hpp"
#include "models/simple_pendulum.hpp"

#include <kanexpr/assemble.hpp>
#include <kanexpr/fixed_step.hpp>
#include <kanexpr/symbolic.hpp>

#include <gtest/gtest.h>

#include <iostream>

namespace {

namespace linkage {

using namespace four_bar;

#include <docs/tour/four_bar.cpp>

using eom = equations_of_motion<System>;

TEST(tour, assembles_a_linkage) {
  const eom::parameters p{{l0, 2}, {l1, 1}, {l2, 2},   {l3, 1.5}, {d1, 0.5}, {d2, 1},   {d3, 0.75},
                          {m1, 1}, {m2, 2}, {m3, 1.5}, {I1, 0.1}, {I2, 0.7}, {I3, 0.3}, {g, 9.81}};
  const eom::inputs r{{T, 0}};
#include <docs/tour/assembled.cpp>
  EXPECT_TRUE(a.status);
  EXPECT_TRUE(check_consistency<System>(x, p, r));
  EXPECT_EQ(a.size(), 3);
  EXPECT_TRUE(force.allFinite());
}

} // namespace linkage

namespace pendulum {

using namespace simple_pendulum;

TEST(tour, prints_linearized_equations) {
  const docs::printed here;
#include <docs/tour/symbols.cpp>
  EXPECT_EQ(here.text(), docs::text("docs/tour/symbols.text"));
}

TEST(tour, makes_a_step) {
  state<System> x{{q, 0.3}, {u, 0}};
  const parameter_values<System> p{{m, 2}, {l, 0.5}, {g, 9.81}, {c, 0.1}};
  input_values<System> r;
  double t = 0;
#include <docs/tour/stepped.cpp>
  EXPECT_EQ(t, 1e-3);
}

} // namespace pendulum
} // namespace
