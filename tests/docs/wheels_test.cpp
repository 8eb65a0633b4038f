// builds: clang++ all
// Wheels on the ground: docs/guide/wheels.md.
#include "docs/no_mistake.hpp"

#include <kanexpr/kanexpr.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/tyres.hpp>
#include <kanexpr/wheels.hpp>

#include <gtest/gtest.h>

namespace {

using docs::expect_no_mistake;

namespace torus {

#include <docs/guide/wheels/torus.cpp>

#include <docs/guide/wheels/uneven.cpp>

#include <docs/guide/wheels/grounds.cpp>

constexpr speed<"wx"> wx;
constexpr speed<"wy"> wy;
constexpr speed<"wz"> wz;
constexpr speed<"vx"> vx;
constexpr speed<"vy"> vy;
constexpr speed<"vz"> vz;

template <class... Loads>
struct free_torus : kane_system<inertial<N>, coordinates<q1, q2, q3, x, y, z>, speeds<wz, wx, wy, vx, vy, vz>,
                                kinematics<simple>, used_elsewhere<R, r, g>, bodies<Torus>, loads<Loads...>> {
};

TEST(wheels, of_a_torus) {
  expect_no_mistake<Rolling>();
  expect_no_mistake<RollingOnWaves>();
  expect_no_mistake<free_torus<hilly>>();
  expect_no_mistake<free_torus<on_rail>>();
}

} // namespace torus

TEST(wheels, in_a_builder) {
  using namespace kanexpr;
  runtime::builder b("N");
  const auto q = b.coordinate("q"), angle = b.coordinate("angle");
  b.kinematic_equation(b.dot(q) - b.speed("u"));
  b.kinematic_equation(b.dot(angle) - b.speed("w"));
  const auto n = b.inertial_frame(), fork = n;
  const auto o = b.origin("O"), hub = b.offset("Hub", o, b.along(n, q, 0, 0.3));
  const auto wheel = b.rotated("Wheel", n, angle, b.along(n, 0, 1, 0));
  b.rigid_body("Rim", hub, wheel, b.number(1), b.inertia(wheel, 0.1, 0.2, 0.1));
#include <docs/guide/wheels/builder.cpp>
  EXPECT_EQ((b.check)().view(), "");
  EXPECT_NE(touching, hub);
  EXPECT_EQ(on_plane.steps, 0);
}

} // namespace
