// builds: clang++ all
// Simulation: docs/simulation.md, except for the bicycle.
#include "docs/printed.hpp"
#include "docs/text.hpp"
#include "models/pendulum_nonminimal.hpp"
#include "models/rotating_tube.hpp"
#include "models/simple_pendulum.hpp"
#include "simulations/falling_ball.hpp"

#include <kanexpr/control.hpp>
#include <kanexpr/fixed_step.hpp>
#include <kanexpr/operating_point.hpp>
#include <kanexpr/simulate.hpp>
#include <kanexpr/simulations/events/impact.hpp>
#include <kanexpr/simulations/prescribe.hpp>
#include <kanexpr/symbolic.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <map>

namespace {

using namespace kanexpr;

TEST(simulation, is_of_a_pendulum) {
#include <docs/simulation/pendulum.cpp>

#include <docs/simulation/by_name.cpp>

#include <docs/simulation/dense.cpp>

#include <docs/simulation/handed_on.cpp>

#include <docs/simulation/inputs.cpp>

#include <docs/simulation/trajectory.cpp>
  EXPECT_EQ(path.size(), 1001);
  EXPECT_NEAR(run.state[q], 0.177082, 5e-7);
  EXPECT_TRUE(same);
  EXPECT_TRUE(kept);
  EXPECT_TRUE(long_run);
  EXPECT_TRUE(out.finish());

  const docs::printed here;
#include <docs/simulation/csv.cpp>
  EXPECT_EQ(read["q"].size(), 1001);
  EXPECT_EQ(read["v"].cause(), "the table has no column v; it has t, q, u and T");
#include <docs/simulation/column.cpp>
  EXPECT_EQ(table.add("energy", path.energies().total).cause(), "column energy already exists");
}

TEST(simulation, prescribes_an_angle) {
#include <docs/simulation/prescribed.cpp>
  ASSERT_TRUE(swung) << swung.cause();
  EXPECT_NEAR(swung.trajectory[0].r[dot(theta)], 1.5, 1e-12);
}

TEST(simulation, has_events) {
  const docs::printed here;
#include <docs/simulation/events.cpp>

#include <docs/simulation/resting.cpp>
  EXPECT_EQ(here.text(), docs::text("docs/simulation/bounces.text"));
  const auto ended = simulate<System>(
      {{h, 2}, {v, 0}}, {{m, 0.3}, {g, 9.81}}, {0, 10},
      {.events = {when<System, dot(position_of<P, O>, N::z)>("contact", crossing::falling, bounce_or_rest)}});
  EXPECT_TRUE(ended.stopped_by_event);
#include <docs/simulation/impact.cpp>
  const auto hits = simulate<System>({{h, 2}, {v, 0}}, {{m, 0.3}, {g, 9.81}}, {0, 10}, {.events = {hit}});
  EXPECT_TRUE(hits.stopped_by_event);
  EXPECT_EQ(hits.events.size(), ended.events.size() + 1); // the speed before the impact is compared
}

TEST(operating_points, hold_a_pendulum) {
#include <docs/simulation/operating_point.cpp>
  EXPECT_NEAR(held.r[T], 7.31537, 5e-6);
}

TEST(operating_points, are_found) {
  using namespace simple_pendulum;
#include <docs/simulation/found.cpp>
  EXPECT_NEAR(operating_point<System>({{q, 1}}, p, {.held = {q}, .rates = {{dot(q), 3}}}).r[T], 8.554830,
              5e-7);
}

int steps() {
#include <docs/simulation/steps.cpp>
  EXPECT_NEAR(t, 1, 1e-12);
#include <docs/simulation/cost.cpp>
  return 0;
}

TEST(fixed_steps, are_made) { EXPECT_EQ(steps(), 0); }

TEST(fixed_steps, pass_singular_positions) {
#include <docs/simulation/passing.cpp>
  EXPECT_TRUE(s) << s.cause();
  EXPECT_NEAR(x[q1], 3e-3 + 9.81e-6 / 2, 1e-8); // it falls from a position next to its pivot
}

TEST(fixed_steps, have_derivatives) {
  using namespace simple_pendulum;
  using eom = equations_of_motion<System>;
  const docs::printed here;
  const eom::state x{{q, 0.3}, {u, 0.1}};
  const eom::parameters p(1, 1, 9.81, 0.1);
  const eom::inputs r(0.0);
  const double t = 0;
#include <docs/simulation/linearized.cpp>
  EXPECT_NE(here.text(), "");
}

} // namespace
