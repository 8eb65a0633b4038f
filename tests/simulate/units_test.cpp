// A pendulum in the two coordinates of its bob, simulated and trimmed in other units.
#include "models/pendulum_nonminimal.hpp"

#include <kanexpr/operating_point.hpp>
#include <kanexpr/simulate.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace pendulum_nonminimal;

simulation<System> swing(double length, double mass, double time) {
  return simulate<System>({{q1, 0.9 * length}, {q2, 0.4 * length}, {u1, 0}, {u2, 0}},
                          {{m, mass}, {L, length}, {g, 9.81 * length / (time * time)}}, {0, 5 * time});
}

TEST(units, do_not_matter_to_a_simulation_at_the_defaults) {
  const auto plain = swing(1, 1, 1);
  ASSERT_TRUE(plain) << plain.cause();
  for (const double scale : {0x1p-40, 0x1p40})
    for (const double time : {0x1p-20, 1.0, 0x1p20}) {
      const auto run = swing(scale, scale, time);
      ASSERT_TRUE(run) << run.cause();
      EXPECT_EQ(run.statistics.steps, plain.statistics.steps) << scale << ' ' << time;
      EXPECT_NEAR(run.state[q1] / scale, plain.state[q1], 1e-12) << scale << ' ' << time;
      EXPECT_NEAR(run.state[u2] / scale * time, plain.state[u2], 1e-12) << scale << ' ' << time;
    }
  for (const double scale : {1e-12, 1e-8, 1e-3, 1e6, 1e12}) {
    const auto run = swing(scale, 1, 1);
    ASSERT_TRUE(run) << run.cause();
    EXPECT_NEAR(run.state[q1] / scale, plain.state[q1], 1e-8) << scale;
    EXPECT_NEAR(std::hypot(run.state[q1], run.state[q2]), scale, 1e-13 * scale);
  }
}

TEST(units, do_not_matter_to_a_motion_that_begins_at_rest) {
  for (const double scale : {1e-12, 1.0, 1e12}) {
    const auto hangs = simulate<System>({{q1, scale}, {q2, 0}, {u1, 0}, {u2, 0}},
                                        {{m, 1}, {L, scale}, {g, 9.81}}, {0, 5 * std::sqrt(scale)});
    ASSERT_TRUE(hangs) << hangs.cause();
    EXPECT_NEAR(hangs.state[q1], scale, 1e-14 * scale);
    EXPECT_NEAR(hangs.state[q2], 0, 1e-14 * scale);
  }
}

TEST(units, do_not_matter_to_an_operating_point) {
  for (const double scale : {1e-6, 1e-3, 1.0, 1e6, 1e12}) {
    const operating_point<System> rest({{q1, 0.8 * scale}, {q2, 0.3 * scale}, {u1, 0}, {u2, 0}},
                                       {{m, 1}, {L, scale}, {g, 9.81}});
    ASSERT_TRUE(rest) << rest.cause();
    EXPECT_NEAR(rest.x[q1], scale, 1e-12 * scale);
    EXPECT_NEAR(rest.x[q2], 0, 1e-12 * scale);
  }
}

} // namespace
