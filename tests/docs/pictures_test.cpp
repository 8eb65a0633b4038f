// builds: clang++ all
// Pictures: docs/pictures.md.
#include "models/double_pendulum.hpp"

#include <kanexpr/animate.hpp>
#include <kanexpr/animate/picture_of.hpp>
#include <kanexpr/beams.hpp>
#include <kanexpr/kanexpr.hpp>
#include <kanexpr/simulate.hpp>

#include <gtest/gtest.h>

#include <iostream>

namespace {

using namespace kanexpr;

#include <docs/pictures/picture.cpp>

#include <docs/pictures/by_default.cpp>

#include <docs/pictures/mesh.cpp>
static_assert(!drawn::mistake);

#include <docs/pictures/curves.cpp>
static_assert(!rope::mistake && !strip::mistake);

#include <docs/pictures/taut.cpp>
static_assert(!hoist::mistake);

#include <docs/pictures/plots.cpp>

#include <docs/pictures/vectors.cpp>

namespace arm {
#include <docs/guide/beams/arm.cpp>
#include <docs/pictures/beam.cpp>
static_assert(!bent_arm::mistake);
} // namespace arm

/// The double pendulum, released at some speed of its lower body.
simulation<System> released(double speed) {
  return simulate<System>(
      {{q1, 0.5}, {q2, 1}, {u1, 0}, {u2, speed}},
      {{m1, 1}, {m2, 1}, {d1, 0.5}, {d2, 0.5}, {l1, 1}, {I1, 0.1}, {I2, 0.1}, {g, 9.81}, {c1, 0}, {c2, 0}},
      {0, 1}, {.inputs = {{T1, 0}, {T2, 0}}, .output_every = 0.02});
}

TEST(pictures, move) {
  const auto run = released(0), pushed = released(2);
  ASSERT_TRUE(run) << run.cause();
#include <docs/pictures/written.cpp>

#include <docs/pictures/default_page.cpp>
  EXPECT_EQ(written.cause(), shown.cause());
#include <docs/pictures/animated.cpp>
  EXPECT_EQ(a.find("sphere at Tip")->placements.size(), 51);

#include <docs/pictures/runs.cpp>

  const animation b = animated<plotted>(run.trajectory), c = animated<explained>(run.trajectory);
  EXPECT_EQ(b.columns.back().name, "total energy");
  ASSERT_NE(c.find("weight of Bar1"), nullptr);
  EXPECT_NEAR(c.find("weight of Bar1")->placements[0].end.norm(), 9.81, 1e-12);
}

} // namespace
