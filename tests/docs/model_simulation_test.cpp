// builds: clang++ all
// Simulations of models derived at run time: docs/guide/builder.md and docs/simulation.md.
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/simulations/model.hpp>
#include <kanexpr/simulations/tables/csv.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

namespace {

using namespace kanexpr;

/// The model on the page about builders, with a motor that an input may drive.
struct pendulum : runtime::builder {
  symbolic::expression q = coordinate("q"), u = speed("u"), m = parameter("m"), l = parameter("l"),
                       g = parameter("g");
  runtime::frame_id n = inertial_frame(), rod = rotated("A", n, q, along(n, 0, 0, 1));

  pendulum() : builder("N") {
    kinematic_equation(dot(q) - u);
    particle("Bob", offset("P", origin("O"), along(rod, l, 0, 0)), m);
    gravity(along(n, g, 0, 0));
  }
};

TEST(model_simulation, moves_what_was_built) {
  const pendulum b;
#include <docs/guide/builder/motion.cpp>
  ASSERT_TRUE(run) << run.cause();
  EXPECT_EQ(run.trajectory["q"].size(), 1001u);
  EXPECT_EQ(run.state["q"], run.trajectory["q"].back());
  const auto energies = run.trajectory.energies().total;
  EXPECT_NEAR(energies.back(), energies.front(), 1e-6);
}

TEST(model_simulation, takes_inputs_and_events_by_name) {
  pendulum b;
  b.torque(b.rod, b.along(b.n, 0, 0, b.input("T")));
  const auto q = b.q, u = b.u;
#include <docs/simulation/of_a_model.cpp>
  ASSERT_TRUE(run) << run.cause();
  EXPECT_TRUE(run.stopped_by_event);
  ASSERT_EQ(run.events.size(), 2u);
  EXPECT_EQ(run.events[0].name, "half way");
  EXPECT_EQ(run.time, 9);
  const auto bent = run.trajectory.along(b.dot(u));
  EXPECT_NEAR(bent[0], 14 - 9.81 * std::sin(0.3), 1e-12);
  EXPECT_EQ(run.trajectory["T"][0], 14);
  const auto read = read_csv("run.csv");
  ASSERT_TRUE(read) << read.cause();
  EXPECT_EQ(read.rows(), run.trajectory.size());
}

} // namespace
