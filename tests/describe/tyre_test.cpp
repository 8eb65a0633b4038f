// The words of tyres, compared with a builder. The systems are derived at run time; their power is in
// mechanics/loads/elements_test.cpp.
#include <kanexpr/joints.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/symbolic.hpp>
#include <kanexpr/tyres.hpp>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

namespace {

using namespace kanexpr;
using Eigen::VectorXd;
using runtime::tyre_data;

constexpr coordinate<"x"> x;
constexpr coordinate<"y"> y;
constexpr coordinate<"z"> z;
constexpr coordinate<"yaw"> yaw;
constexpr coordinate<"lean"> lean;
constexpr coordinate<"spin"> spin;
constexpr speed<"ux"> ux;
constexpr speed<"uy"> uy;
constexpr speed<"uz"> uz;
constexpr speed<"uyaw"> uyaw;
constexpr speed<"ulean"> ulean;
constexpr speed<"uspin"> uspin;
constexpr parameter<"mu"> mu;
constexpr parameter<"C"> stiffness;
constexpr parameter<"v0"> v0;
constexpr parameter<"Fz"> load_given;

struct N : inertial_frame<N> {};
struct O : origin<O, N> {};
struct Yawed : rotated<Yawed, N, yaw, N::z> {};
struct Leaning : rotated<Leaning, Yawed, lean, Yawed::x> {};
struct Rolling : rotated<Rolling, Leaning, spin, Leaning::y> {};
struct Hub : offset<Hub, O, x * N::x + y * N::y + z * N::z> {};
struct Wheel : rigid_body<Wheel, Hub, Rolling, 12, inertia<Rolling, 0.3, 0.5, 0.3>> {};

using rim = toroidal_wheel<Hub, Leaning::y, 0.25, 0.05, Rolling>;
using street = flat_ground<O, N::z>;

template <class... Loads>
struct wheel_alone
    : kane_system<inertial<N>, coordinates<x, y, z, yaw, lean, spin>, speeds<ux, uy, uz, uyaw, ulean, uspin>,
                  kinematics<dot(x) == ux, dot(y) == uy, dot(z) == uz, dot(yaw) == uyaw, dot(lean) == ulean,
                             dot(spin) == uspin>,
                  parameters<mu, stiffness, v0, load_given>, used_elsewhere<mu, stiffness, v0, load_given>,
                  bodies<Wheel>, loads<Loads...>> {};

// The same system from a builder.
struct built : runtime::builder {
  mechanics::expression turned = coordinate("x"), aside = coordinate("y"), height = coordinate("z"),
                        heading = coordinate("yaw"), leaning = coordinate("lean"), angle = coordinate("spin"),
                        friction = parameter("mu"), elastic = parameter("C"), slow = parameter("v0"),
                        weight = parameter("Fz");
  runtime::frame_id n = inertial_frame(), b{}, l{};
  runtime::point_id o{}, hub{};

  built() : builder("N") {
    kinematic_equation(dot(turned) - speed("ux"));
    kinematic_equation(dot(aside) - speed("uy"));
    kinematic_equation(dot(height) - speed("uz"));
    kinematic_equation(dot(heading) - speed("uyaw"));
    kinematic_equation(dot(leaning) - speed("ulean"));
    kinematic_equation(dot(angle) - speed("uspin"));
    const auto yawed = rotated("Yawed", n, heading, along(n, 0, 0, 1));
    l = rotated("Leaning", yawed, leaning, along(yawed, 1, 0, 0));
    b = rotated("Rolling", l, angle, along(l, 0, 1, 0));
    o = origin("O");
    hub = offset("Hub", o, along(n, turned, aside, height));
    rigid_body("Wheel", hub, b, number(12), inertia(b, 0.3, 0.5, 0.3));
    for (const auto& e : {friction, elastic, slow, weight}) used_elsewhere(e);
  }

  runtime::wheel_on_ground wheel() {
    return wheel_on_plane({hub, b, along(l, 0, 1, 0), 0.25, 0.05}, o, along(n, 0, 0, 1));
  }
};

void expect_same(model words, model builds, int states) {
  ASSERT_EQ(words.mistake(), "");
  ASSERT_EQ(builds.mistake(), "");
  auto first = words.function(words.rhs()), second = builds.function(builds.rhs());
  std::mt19937_64 source(7);
  std::uniform_real_distribution<double> values(0.1, 0.6);
  for (int i = 0; i < 10; ++i) {
    const VectorXd state = VectorXd::NullaryExpr(states, [&] { return values(source); });
    const VectorXd p = VectorXd::NullaryExpr(4, [&] { return 1 + values(source); });
    ASSERT_TRUE(first(state, p).allFinite());
    EXPECT_LT((first(state, p) - second(state, p)).norm(), 1e-13 * first(state, p).norm());
  }
}

TEST(tyre_words, of_a_linear_tyre_with_relaxation_lengths) {
  using words =
      wheel_alone<tyre<rim, street, linear_tyre<3 * stiffness, stiffness>, camber_stiffness<0.1 * stiffness>,
                       relaxation<0.2, 0.4>, standstill<v0>, pneumatic_trail<0.03>>>;
  built s;
  tyre_data t = tyre_data::linear(3 * s.elastic, s.elastic);
  t.camber_stiffness = 0.1 * s.elastic, t.standstill = s.slow, t.trail = 0.03;
  t.relaxation = {0.2, 0.4, s.state_variable("dx_Hub"), s.state_variable("dy_Hub")};
  s.tyre(s.wheel(), t);
  expect_same(derive<words>(), derive(s), 14);
}

TEST(tyre_words, of_brush_tyres) {
  using words = wheel_alone<tyre<rim, street, brush_tyre<mu, stiffness>, wheel_load<load_given * x>,
                                 standstill<v0>, effective_radius<0.29>, relaxation<0.2, 0.4>>>;
  built s;
  tyre_data t = tyre_data::brush(s.friction, s.elastic);
  t.load = s.weight * s.turned, t.standstill = s.slow, t.effective_radius = 0.29;
  t.relaxation = {0.2, 0.4, s.state_variable("dx_Hub"), s.state_variable("dy_Hub")};
  s.tyre(s.wheel(), t);
  expect_same(derive<words>(), derive(s), 14);

  using on_spring =
      wheel_alone<tyre<rim, street, brush_tyre<mu, stiffness, 2 * stiffness>,
                       radial_stiffness<1e3, 0.1, 0.01>, standstill<v0>, pneumatic_trail<0.02>>>;
  built other;
  tyre_data r = tyre_data::brush(other.friction, other.elastic, 2 * other.elastic);
  r.radial = {1e3, 0.1, 0.01}, r.standstill = other.slow, r.trail = 0.02;
  other.tyre(other.wheel(), r);
  expect_same(derive<on_spring>(), derive(other), 12);
}

inline constexpr tyre_coefficients slick{.Fz0 = 4000,
                                         .R0 = 0.3,
                                         .pCx1 = 1.6,
                                         .pDx1 = mu,
                                         .pKx1 = 20,
                                         .rBx1 = 10,
                                         .rCx1 = 1,
                                         .pCy1 = 1.3,
                                         .pDy1 = mu,
                                         .pKy1 = -15,
                                         .pKy2 = 1.5,
                                         .pKy4 = 2,
                                         .rBy1 = 8,
                                         .rCy1 = 1.1,
                                         .qBz1 = 9,
                                         .qBz9 = 10,
                                         .qCz1 = 1.2,
                                         .qDz1 = 0.1,
                                         .qDz8 = -0.3,
                                         .qsx2 = 0.5,
                                         .qsy1 = 0.01};

TEST(tyre_words, of_a_magic_formula) {
  using words = wheel_alone<
      tyre<rim, street, kanexpr::magic_formula<slick>, wheel_load<load_given * x>, standstill<v0>>>;
  built s;
  tyre_data t = tyre_data::of_formula({.Fz0 = 4000,
                                       .R0 = 0.3,
                                       .pCx1 = 1.6,
                                       .pDx1 = s.friction,
                                       .pKx1 = 20,
                                       .rBx1 = 10,
                                       .rCx1 = 1,
                                       .pCy1 = 1.3,
                                       .pDy1 = s.friction,
                                       .pKy1 = -15,
                                       .pKy2 = 1.5,
                                       .pKy4 = 2,
                                       .rBy1 = 8,
                                       .rCy1 = 1.1,
                                       .qBz1 = 9,
                                       .qBz9 = 10,
                                       .qCz1 = 1.2,
                                       .qDz1 = 0.1,
                                       .qDz8 = -0.3,
                                       .qsx2 = 0.5,
                                       .qsy1 = 0.01});
  t.load = s.weight * s.turned, t.standstill = s.slow;
  s.tyre(s.wheel(), t);
  expect_same(derive<words>(), derive(s), 12);
}

} // namespace
