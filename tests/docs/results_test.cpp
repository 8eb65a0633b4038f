// Results, values and their status: docs/guide/results.md.
#include "docs/printed.hpp"
#include "models/rolling_disc.hpp"
#include "models/simple_pendulum.hpp"

#include <kanexpr/compiled/constant_values.hpp>
#include <kanexpr/symbolic.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

namespace {

using namespace kanexpr;

namespace arm {

constexpr coordinate<"q1"> q1;
constexpr coordinate<"q2"> q2;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr parameter<"m"> m;
constexpr parameter<"l"> l;
constexpr input<"F"> F;
constexpr input<"T"> T;

struct N : inertial_frame<N> {};
struct Upper : rotated<Upper, N, q1, N::z> {};
struct Lower : rotated<Lower, N, q2, N::z> {};
struct O : origin<O, N> {};
struct Elbow : offset<Elbow, O, l * Upper::x> {};
struct P : offset<P, Elbow, l * Lower::x> {};
struct First : particle<First, Elbow, m> {};
struct Second : particle<Second, P, m> {};
struct System : kane_system<inertial<N>, coordinates<q1, q2>, speeds<u1, u2>,
                            kinematics<dot(q1) == u1, dot(q2) == u2>, parameters<m, l>, inputs<F, T>,
                            bodies<First, Second>, loads<force<P, F * N::x>, torque<Upper, T * N::z>>> {};

TEST(results, are_called) {
  const state<System> x{{q1, 0.1}, {u1, 2}, {q2, 0.7}, {u2, 3}};
  const parameter_values<System> p(2, 1);
  const input_values<System> r(0.5, 0);
#include <docs/guide/results/results.cpp>
  EXPECT_NEAR(M(0, 0), 4, 1e-12);
  EXPECT_NEAR(M(1, 1), 2, 1e-12);
  EXPECT_EQ(f.size(), 2);
  EXPECT_GT(energy, 0);
  EXPECT_NEAR(v(0), -2 * std::sin(0.1) - 3 * std::sin(0.7), 1e-12);
}

TEST(results, are_of_points_that_the_system_does_not_use) {
  const docs::printed here;
  const state<System> x{{q1, 0.1}, {u1, 2}, {q2, 0.7}, {u2, 3}};
  const parameter_values<System> p(2, 1);
  const input_values<System> r(0.5, 0);
#include <docs/guide/results/late.cpp>
  EXPECT_NEAR(seen(0), -2 * std::sin(0.1) - 1.5 * std::sin(0.7), 1e-12);
  EXPECT_EQ(here.text(), "-(l*u1*sin(q1) + l*u2*sin(q2)/2)*N.x + (l*u1*cos(q1) + l*u2*cos(q2)/2)*N.y\n");
  EXPECT_EQ(checked.mistake(), "");
}

TEST(results, bring_about_wanted_rates) {
  using eom = equations_of_motion<System>;
  const state<System> x{{q1, 0.1}, {u1, 2}, {q2, 0.7}, {u2, 3}};
  const parameter_values<System> p(2, 1);
  const Eigen::Vector2d q(0.1, 0.7), u(2, 3), wanted_coordinates(0.2, 0.6), wanted_speeds(1, 1),
      wanted_rates(4, 5);
#include <docs/guide/results/computed_torque.cpp>
  ASSERT_TRUE(torques.status);
  const eom::inputs r(torques(0), torques(1));
#include <docs/guide/results/derivatives.cpp>
  EXPECT_EQ(by_state.cols(), 4);
  EXPECT_LE((by_rates - eom::mass_matrix(x, p)).norm(), 1e-14);
  EXPECT_LE((eom::udot(x, p, r) - Eigen::Vector2d(4 - 20 + 10, 5 - 40 - 10)).norm(), 1e-10);
}

TEST(results, take_values) {
  using eom = equations_of_motion<System>;
#include <docs/guide/results/values.cpp>
  EXPECT_EQ(x, Eigen::Vector4d(0.1, 0, 2, 0));
  EXPECT_EQ(p, Eigen::Vector2d(2, 1));
#include <docs/guide/results/mistake.cpp>
  EXPECT_FALSE(p.mistake());
  eom::parameters half;
  half[m] = 2;
  EXPECT_EQ(half.mistake().cause(), "parameter l has no value");
}

} // namespace arm

namespace pendulum {

using namespace simple_pendulum;
using eom = equations_of_motion<System>;

TEST(results, are_constants) {
#include <docs/guide/results/constant.cpp>
  EXPECT_NEAR(std::get<0>(both)(1, 0), -10 / 3.0 * std::cos(0.5), 1e-14);
}

} // namespace pendulum

namespace disc {

using namespace rolling_disc;

TEST(results, have_a_status) {
  using eom = equations_of_motion<System>;
  const eom::state x{{q1, 0}, {q2, 0.2}, {q3, 0}, {u1, 0}, {u2, 3}, {u3, 0}};
  const eom::parameters p{{m, 2}, {r, 0.4}, {g, 9.81}};
#include <docs/guide/results/status.cpp>
  EXPECT_TRUE(a.status);
}

} // namespace disc
} // namespace
