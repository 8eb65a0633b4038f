// builds: clang++ all
// Tyres: docs/guide/tyres.md.
#include "docs/no_mistake.hpp"

#include <kanexpr/kanexpr.hpp>
#include <kanexpr/operating_point.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/runtime/read_tir.hpp>
#include <kanexpr/tyres.hpp>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <string>

namespace {

using docs::expect_no_mistake;

namespace car {

#include <docs/guide/tyres/car.cpp>

#include <docs/guide/tyres/relaxation.cpp>

#include <docs/guide/tyres/formula.cpp>

#include <docs/guide/tyres/quantities.cpp>

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

// The brush model, written out.
TEST(tyres, have_forces_and_slips_as_results) {
  auto model = derive<System>();
  const symbolic::matrix each[]{model.get<load>(),     model.get<driving>(), model.get<side>(),
                                model.get<aligning>(), model.get<slip>(),    model.get<angle>(),
                                model.get<camber>()};
  symbolic::matrix all(model.graph(), 7, 1);
  for (int i = 0; i < 7; ++i) all(i, 0) = each[i](0, 0);
  ASSERT_EQ(model.mistake(), "");
  auto results = model.function(all);
  const double steering = 0.04, friction = 0.9, stiffness = 9e4, slow = 0.1, radius = 0.3;
  const parameter_values<System> p{{m, 1500},   {g, 9.81},      {a, 1.2},       {b, 1.6},
                                   {R, radius}, {mu, friction}, {C, stiffness}, {v0, slow}};
  const input_values<System> given{{delta, steering}, {T, 0}};
  for (const double ahead : {20.0, 3.0, -4.0})
    for (const double turning : {0.25, -0.6}) {
      const double aside = 0.1 * ahead * turning, spin = 1.01 * ahead / radius;
      const state<System> at{{car::x, 1}, {psi, 0.3},   {u, ahead},
                             {v, aside},  {r, turning}, {front_spin, spin}};
      const Eigen::VectorXd found = results(at, p, given);
      const double leftward = aside + 1.2 * turning, of_x = std::cos(steering), of_y = std::sin(steering);
      const double passing = std::hypot(radius * spin, slow);
      const double slip_x = -(ahead * of_x + leftward * of_y - radius * spin) / passing,
                   slip_y = -(leftward * of_x - ahead * of_y) / passing;
      const double pressed = 1500 * 9.81 * 1.6 / 2.8, size = std::hypot(slip_x, slip_y),
                   sticking = std::fmax(0, 1 - stiffness * size / (3 * friction * pressed)),
                   force = friction * pressed * (1 - sticking * sticking * sticking);
      EXPECT_NEAR(found[0], pressed, 1e-12 * pressed);
      EXPECT_NEAR(found[1], force * slip_x / size, 1e-7 * pressed); // rounded without slip
      EXPECT_NEAR(found[2], force * slip_y / size, 1e-7 * pressed);
      EXPECT_EQ(found[3], 0); // it has no pneumatic trail
      EXPECT_NEAR(found[4], slip_x, 1e-13);
      EXPECT_NEAR(found[5], std::atan(-slip_y), 1e-13);
      EXPECT_EQ(found[6], 0);
    }
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
#include <docs/guide/tyres/builder_forces.cpp>
  EXPECT_TRUE(side.is_zero()); // the wheel moves in its plane
  testing::internal::CaptureStderr();
#include <docs/guide/tyres/tir.cpp>
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "slick.tir cannot be read\n");
  EXPECT_EQ((b.check)().view(), "");
}

} // namespace
