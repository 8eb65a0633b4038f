// Tyres: docs/guide/tyres.md.
#include "docs/no_mistake.hpp"

#include <kanexpr/kanexpr.hpp>
#include <kanexpr/operating_point.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/tyres.hpp>

#include <Eigen/Core>
#include <gtest/gtest.h>

namespace {

using docs::expect_no_mistake;

namespace car {

#include <docs/guide/tyres/car.cpp>

#include <docs/guide/tyres/relaxation.cpp>

#include <docs/guide/tyres/formula.cpp>

template <class... Tyres>
struct with
    : kane_system<inertial<N>, coordinates<x, y, psi, front_angle, rear_angle>,
                  speeds<u, v, r, front_spin, rear_spin>,
                  kinematics<dot(x) == u * cos(psi) - v * sin(psi), dot(y) == u * sin(psi) + v * cos(psi),
                             dot(psi) == r, dot(front_angle) == front_spin, dot(rear_angle) == rear_spin>,
                  bodies<Car, FrontWheel, RearWheel>, loads<Tyres...>> {};

TEST(tyres, of_a_car) {
  expect_no_mistake<System>();
  expect_no_mistake<with<LaggingTyre, RearTyre>>();
  expect_no_mistake<with<FormulaTyre, RearTyre>>();
}

TEST(tyres, have_units) {
  EXPECT_EQ(units_of<System>(mu), kanexpr::units::dimensionless);
  EXPECT_EQ((units_of<with<LaggingTyre>>(lateral_deflection_of<FrontHub>)), meter);
}

TEST(tyres, hold_a_car_in_a_turn) {
#include <docs/guide/tyres/turn.cpp>
  ASSERT_TRUE(turn) << turn.cause();
  EXPECT_NEAR(turn.r[delta], 0.04988, 5e-6);
  EXPECT_NEAR(turn.r[T], 131.5, 0.05);
  EXPECT_NEAR(turn.x[v], -0.5684, 5e-5);
  EXPECT_EQ(turn.freedom, 5);
}

} // namespace car

TEST(tyres, in_a_builder) {
  using namespace kanexpr;
  runtime::builder b("N");
  const auto q = b.coordinate("q"), angle = b.coordinate("angle");
  b.kinematic_equation(b.dot(q) - b.speed("u"));
  b.kinematic_equation(b.dot(angle) - b.speed("w"));
  const auto n = b.inertial_frame(), fork = n;
  const auto o = b.origin("O"), hub = b.offset("Hub", o, b.along(n, q, 0, 0.3));
  const auto wheel = b.rotated("Wheel", n, angle, b.along(n, 0, 1, 0));
  b.rigid_body("Rim", hub, wheel, b.number(1), b.inertia(wheel, 0.1, 0.2, 0.1));
#include <docs/guide/tyres/builder.cpp>
  EXPECT_EQ((b.check)().view(), "");
}

} // namespace
