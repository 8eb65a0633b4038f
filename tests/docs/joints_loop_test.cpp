// builds: clang++ all
// A closed loop of joints: docs/guide/joints.md.
#include "docs/joints_loop.hpp"

#include <models/four_bar.hpp>

#include <gtest/gtest.h>

namespace {

using namespace kanexpr;

using namespace docs::loop;

// The four-bar linkage of the examples, described by frames and points.
TEST(joints, close_a_loop) {
  using eom = equations_of_motion<Linkage>;
  using example = equations_of_motion<four_bar::System>;
  eom::parameters p;
  example::parameters same;
  double next = 0.4;
  const auto give = [&](auto symbol, auto of_example) { p[symbol] = same[of_example] = next += 0.13; };
  give(l0, four_bar::l0), give(l1, four_bar::l1), give(l2, four_bar::l2), give(l3, four_bar::l3);
  give(d1, four_bar::d1), give(d2, four_bar::d2), give(d3, four_bar::d3), give(g, four_bar::g);
  give(m1, four_bar::m1), give(m2, four_bar::m2), give(m3, four_bar::m3);
  give(I1, four_bar::I1), give(I2, four_bar::I2), give(I3, four_bar::I3);
  const Eigen::Vector<double, 6> x{0.6, 0.3, -1.7, 1.4, -0.8, 0.5};
  const auto a = eom::udot(eom::state(x), p, eom::inputs(0.9));
  const auto b = example::udot(example::state(x), same, example::inputs(0.9));
  ASSERT_TRUE(a.status) << a.status.cause();
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1e-12 * (1 + b.norm()));
  EXPECT_LT(
      (eom::constraint_residual(eom::state(x), p) - example::constraint_residual(example::state(x), same))
          .norm(),
      1e-12);
}

} // namespace
