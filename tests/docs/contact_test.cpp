// builds: clang++ all
// Contact and friction: docs/guide/contact.md.
#include "docs/no_mistake.hpp"

#include <kanexpr/contact.hpp>
#include <kanexpr/joints.hpp>
#include <kanexpr/kanexpr.hpp>
#include <kanexpr/runtime/builder.hpp>

#include <Eigen/Core>
#include <gtest/gtest.h>

namespace {

using namespace kanexpr;
using docs::expect_no_mistake;

namespace thrown {

#include <docs/guide/contact/ball.cpp>

/// The speed after an impact at the given speed, without gravity.
double rebound(double speed) {
  auto model = derive<System>();
  auto rhs = model.function(model.rhs());
  Eigen::VectorXd p(7), x = Eigen::VectorXd::Zero(13);
  for (int i = 0; i < 7; ++i) {
    const std::string called = symbolic::print(model.mechanism().parameters[i]);
    p[i] = called == "m"   ? 0.2
           : called == "r" ? 0.05
           : called == "k" ? 1e5
           : called == "w" ? 1e-4
           : called == "v" ? 1
                           : 0;
  }
  x[2] = 0.0501, x[6] = 1, x[9] = -speed;
  for (int i = 0; i < 4000 && !(x[2] > 0.0501 && x[9] > 0); ++i) {
    const double h = 2e-5 / std::sqrt(speed);
    const Eigen::VectorXd k1 = rhs(x, p), k2 = rhs(x + h / 2 * k1, p), k3 = rhs(x + h / 2 * k2, p),
                          k4 = rhs(x + h * k3, p);
    x += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return x[9];
}

TEST(contact, of_a_ball) {
  expect_no_mistake<System>();
  EXPECT_NEAR(rebound(1), 0.7, 1e-6);
  EXPECT_NEAR(rebound(0.1) / 0.1, 0.96, 0.005);
}

} // namespace thrown

// Declarations that the snippets use.
namespace given {

constexpr parameter<"k"> k;
constexpr parameter<"w"> w;
constexpr parameter<"c"> c;
constexpr parameter<"N_bearing"> N_bearing;
constexpr parameter<"r_bearing"> r_bearing;
constexpr parameter<"F_dry"> F_dry;
constexpr coordinate<"q1"> q1;
constexpr coordinate<"q2"> q2;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
struct N : inertial_frame<N> {};
struct O : origin<O, N> {};
struct Wheel : rotated<Wheel, N, q1, N::y> {};
struct Hub : offset<Hub, O, q2 * N::z> {};
struct Foot : offset<Foot, Hub, 0.2 * Wheel::x> {};
struct Body : rigid_body<Body, Hub, Wheel, 1, inertia<Wheel, 1, 1, 1>> {};
struct Ground : inertial_ground<Ground> {};
struct Crank : pin<Crank, Ground, axis<own::z>, body<1, 0.1 * own::x, inertia<own, 1, 1, 1>>> {};
struct Piston : prismatic<Piston, Crank, axis<Crank::x>, body<1, 0.1 * own::x, inertia<own, 1, 1, 1>>> {};
struct Tip : offset<Tip, Piston, 0.1 * Piston::x> {};
constexpr parameter<"sigma"> sigma;

} // namespace given

TEST(contact, of_other_shapes) {
  using namespace given;
  expect_no_mistake<kane_system<inertial<N>, coordinates<q1, q2>, speeds<u1, u2>,
                                kinematics<dot(q1) == u1, dot(q2) == u2>, bodies<Body>,
                                loads<
#include <docs/guide/contact/shapes.cpp>
                                    >>>();
}

TEST(contact, friction_of_joints) {
  using namespace given;
  expect_no_mistake<kane_system<inertial<Ground>, joints<Crank, Piston>,
                                loads<
#include <docs/guide/contact/friction.cpp>
                                    >>>();
}

TEST(contact, friction_with_a_direction) {
  using namespace given;
  expect_no_mistake<kane_system<inertial<Ground>, joints<Crank, Piston>,
                                loads<
#include <docs/guide/contact/directional.cpp>
                                    >>>();
}

namespace quantities {

using namespace given;

#include <docs/guide/contact/forces.cpp>

TEST(contact, has_forces_as_results) {
  expect_no_mistake<Braked>();
  auto model = derive<Braked>();
  EXPECT_EQ(model.get<pressing>().rows, 1);
  EXPECT_EQ(model.get<rubbing>().rows, 1);
  EXPECT_EQ(model.mistake(), "");
}

} // namespace quantities

TEST(contact, friction_with_bristles) {
  using namespace given;
  using System = kane_system<inertial<Ground>, joints<Crank, Piston>,
                             loads<
#include <docs/guide/contact/bristles.cpp>
                                 >>;
  expect_no_mistake<System>();
  state<System> x = state<System>::Ones();
#include <docs/guide/contact/deflection.cpp>
  EXPECT_EQ(x.z(), Eigen::Vector4d::Zero());
  EXPECT_EQ(x(0), 1);
}

TEST(contact, in_a_builder) {
  runtime::builder b("N");
  const auto q = b.coordinate("q");
  b.kinematic_equation(b.dot(q) - b.speed("u"));
  const auto floor = b.origin("O"), center = b.offset("C", floor, b.along(b.inertial_frame(), 0, 0, q));
  const auto ball = b.body_fixed("B", b.inertial_frame(), "xyz", b.number(0.1), b.number(0.2), b.number(0.3));
  b.particle("Ball", center, b.number(1));
#include <docs/guide/contact/builder.cpp>
#include <docs/guide/contact/builder_forces.cpp>
  EXPECT_EQ((b.check)().view(), "");
  auto model = derive(b);
  symbolic::matrix force(b.graph(), 1, 1);
  force.entries[0] = pressing;
  EXPECT_EQ(model.function(force)(Eigen::Vector2d(0.2, 0), Eigen::VectorXd::Constant(1, 100))(0), 0);
  EXPECT_EQ(rubbing.parts.size(), 1);
}

} // namespace
