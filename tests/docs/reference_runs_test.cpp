// builds: clang++ all
// Examples of single names of values, and simulations: docs/reference/examples.md.
#include <kanexpr/assemble.hpp>
#include <kanexpr/batch.hpp>
#include <kanexpr/control.hpp>
#include <kanexpr/fixed_step.hpp>
#include <kanexpr/operating_point.hpp>
#include <kanexpr/runtime/base_parameters.hpp>
#include <kanexpr/simulate.hpp>
#include <models/simple_pendulum.hpp>

#include <gtest/gtest.h>

#include <iostream>
#include <stdexcept>

namespace {

using namespace simple_pendulum;
using eom = equations_of_motion<System>;

#include <docs/reference/examples/values.cpp>

const eom::state x{{q, 0.3}, {u, 0.1}};
const eom::parameters p(1, 0.5, 9.81, 0.1);
const eom::inputs r(0.0);

TEST(reference, has_statuses) {
#include <docs/reference/examples/status.cpp>
  EXPECT_TRUE(rate.status);
  EXPECT_NO_THROW(require(rate));
  EXPECT_THROW(require(eom::udot(x, eom::parameters(0, 0.5, 9.81, 0.1), r)), std::runtime_error);
}

constexpr coordinate<"s"> s;
constexpr coordinate<"w"> w;
struct On_arc : offset<On_arc, O, s * N::x + w * N::y> {};
constexpr speed<"v"> v;
struct Pearl : particle<Pearl, On_arc, 1> {};
struct Bead : kane_system<inertial<N>, coordinates<s, w>, speeds<u, v>, kinematics<dot(s) == u, dot(w) == v>,
                          bodies<Pearl>, configuration_constraints<s * s + w * w == 1>> {};

TEST(reference, has_assembled_states) {
  equations_of_motion<Bead>::state x{{s, 0.6}, {w, 0.7}, {u, 0.1}, {v, 0.2}};
#include <docs/reference/examples/assembled.cpp>
  EXPECT_TRUE(done && checked && rows);
}

TEST(reference, has_points) {
  {
#include <docs/reference/examples/operating_points.cpp>
    EXPECT_TRUE(still) << still.cause();
    EXPECT_FALSE(there.entries().empty());
  }
#include <docs/reference/examples/point_value.cpp>
  EXPECT_EQ(at.entries().size(), 2u);
#include <docs/reference/examples/base_parameters.cpp>
  EXPECT_TRUE(found) << found.cause();
}

TEST(reference, has_regulators) {
  const Eigen::Matrix2d A{{0, 1}, {2, 0}};
  const Eigen::Vector2d B(0, 1);
#include <docs/reference/examples/control.cpp>
  EXPECT_TRUE(regulator && gains);
  double t = 0;
  const double h = 0.01;
  eom::state at = x;
#include <docs/reference/examples/steps.cpp>
  EXPECT_TRUE(first && second && ahead.status);
  EXPECT_EQ(t, 2 * h);
}

TEST(reference, has_simulations) {
#include <docs/reference/examples/simulation.cpp>
  EXPECT_TRUE(end.stopped_by_event);
  EXPECT_GT(work.steps, 0);
  EXPECT_GT(along.total.size(), 1u);
}

TEST(reference, has_batches) {
#include <docs/reference/examples/batches.cpp>
  EXPECT_EQ(rates.size(), 1000);
}

} // namespace
