// builds: clang++ all
// The words of contacts and friction, compared with a builder and with loads that are written out. The
// systems are derived at run time, because only the reading is compared.
#include <kanexpr/contact.hpp>
#include <kanexpr/joints.hpp>
#include <kanexpr/mechanics/loads/friction_law.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/symbolic.hpp>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <random>
#include <string>

namespace {

using namespace kanexpr;
using Eigen::VectorXd;
using mechanics::friction_law;

constexpr coordinate<"x"> x;
constexpr coordinate<"z"> z;
constexpr coordinate<"a"> a;
constexpr speed<"vx"> vx;
constexpr speed<"vz"> vz;
constexpr speed<"wy"> wy;
constexpr parameter<"m"> m;
constexpr parameter<"r"> r;
constexpr parameter<"k"> k;
constexpr parameter<"mu"> mu;
constexpr parameter<"v"> v;

struct N : inertial_frame<N> {};
struct O : origin<O, N> {};
struct B : rotated<B, N, a, N::y> {};
struct C : offset<C, O, x * N::x + z * N::z> {};
struct Body : rigid_body<Body, C, B, m, inertia<B, 0.1, 0.2, 0.3>> {};
struct Fixed : offset<Fixed, O, 0.3 * N::x - 0.2 * N::z> {};

template <class... Loads>
struct thrown : kane_system<inertial<N>, coordinates<x, z, a>, speeds<vx, vz, wy>,
                            kinematics<dot(x) == vx, dot(z) == vz, dot(a) == wy>, parameters<m, r, k, mu, v>,
                            used_elsewhere<m, r, k, mu, v>, bodies<Body>, loads<Loads...>> {};

/// The same system from a builder.
struct built : runtime::builder {
  mechanics::expression position = coordinate("x"), height = coordinate("z"), angle = coordinate("a"),
                        mass = parameter("m"), radius = parameter("r"), stiffness = parameter("k"),
                        coefficient = parameter("mu"), approach = parameter("v");
  runtime::frame_id n = inertial_frame(), b{};
  runtime::point_id o{}, c{}, fixed{};

  built() : builder("N") {
    kinematic_equation(dot(position) - speed("vx"));
    kinematic_equation(dot(height) - speed("vz"));
    kinematic_equation(dot(angle) - speed("wy"));
    b = rotated("B", n, angle, along(n, 0, 1, 0));
    o = origin("O");
    c = offset("C", o, along(n, position, 0, height));
    fixed = offset("Fixed", o, along(n, 0.3, 0, -0.2));
    rigid_body("Body", c, b, mass, inertia(b, 0.1, 0.2, 0.3));
    for (const auto& e : {mass, radius, stiffness, coefficient, approach}) used_elsewhere(e);
  }
};

void expect_same(model words, model builds, int states = 6) {
  ASSERT_EQ(words.mistake(), "");
  ASSERT_EQ(builds.mistake(), "");
  auto first = words.function(words.rhs()), second = builds.function(builds.rhs());
  std::mt19937_64 source(7);
  std::uniform_real_distribution<double> values(0.1, 0.6);
  for (int i = 0; i < 10; ++i) {
    const VectorXd state = VectorXd::NullaryExpr(states, [&] { return values(source); });
    const VectorXd p = VectorXd::NullaryExpr(5, [&] { return values(source); });
    EXPECT_LT((first(state, p) - second(state, p)).norm(), 1e-13 * first(state, p).norm());
  }
}

TEST(contact_words, mean_the_same_as_in_a_builder) {
  using words = thrown<
      contact<sphere_on_plane<C, r, O, N::z, B>, elastic<k, 1.5>, smoothed_over<0.1>, restitution<0.7, v>,
              coulomb_friction<mu>, rolling_resistance<0.02, 0.1>, spinning_resistance<0.03, 0.2>>>;
  built s;
  runtime::contact_data data{.stiffness = s.stiffness, .exponent = 1.5, .width = 0.1};
  data.restitution = {0.7, s.approach};
  data.friction = friction_law::coulomb(s.coefficient, {});
  data.rolling = {s.number(0.02), s.number(0.1)};
  data.spinning = {s.number(0.03), s.number(0.2)};
  s.sphere_on_plane(s.c, s.b, s.radius, s.o, s.along(s.n, 0, 0, 1), data);
  expect_same(derive<words>(), derive(s));
}

// The friction under a skate: the forces of all slips form an ellipse, whose axes are those of the blade.
TEST(contact_words, with_a_direction_of_friction) {
  using Ice = contact<sphere_on_plane<C, r, O, N::z, B>, elastic<k, 1.5>, smoothed_over<0.1>, dissipation<v>,
                      coulomb_friction<mu, 0.1>, directional_friction<2 * N::x + N::y, 0.3>>;
  built s;
  runtime::contact_data data{.stiffness = s.stiffness, .exponent = 1.5, .width = 0.1};
  data.damping = s.approach;
  data.friction = friction_law::coulomb(s.coefficient, s.number(0.1));
  data.directional = {s.along(s.n, 2, 1, 0), 0.3};
  s.sphere_on_plane(s.c, s.b, s.radius, s.o, s.along(s.n, 0, 0, 1), data);
  expect_same(derive<thrown<Ice>>(), derive(s));

  model words = derive<thrown<Ice>>();
  auto force = words.function(words.get<friction_force_of<Ice>>()),
       normal = words.function(words.get<normal_force_of<Ice>>());
  std::mt19937_64 source(5);
  std::uniform_real_distribution<double> values(0.1, 0.6);
  for (int i = 0; i < 10; ++i) {
    VectorXd state = VectorXd::NullaryExpr(6, [&] { return values(source) - 0.3; });
    state(1) = 0.2;
    const VectorXd p{{1, 0.6, 50, 0.7, 0.4}};
    const double slip = state(3) - 0.6 * state(5), along = 2 * slip / std::sqrt(5),
                 across = -slip / std::sqrt(5);
    const double size = std::sqrt(0.09 * along * along + across * across + 0.01);
    const double factor = -0.7 * normal(state, p)(0) / size;
    const VectorXd f = force(state, p);
    EXPECT_NEAR(f(0), factor * (0.09 * along * 2 - across) / std::sqrt(5), 1e-12 * f.norm());
    EXPECT_NEAR(f(1), factor * (0.09 * along + across * 2) / std::sqrt(5), 1e-12 * f.norm());
    EXPECT_NEAR(f(2), 0, 1e-15);
    EXPECT_LE(f(0) * slip, 0);
  }
}

// A skate whose bristles hold it across the blade: the power of the force is that of the bristles under the
// stretched slip.
TEST(contact_words, with_bristles_and_a_direction) {
  using Ice = contact<sphere_on_plane<C, r, O, N::z, B>, elastic<k, 1.5>, smoothed_over<0.1>,
                      lugre_friction<0.7, mu, 0.3, 20, 0.2, 0.1>, directional_friction<N::x, 0.3>>;
  using Plain = contact<sphere_on_plane<C, r, O, N::z, B>, elastic<k, 1.5>, smoothed_over<0.1>,
                        lugre_friction<0.7, mu, 0.3, 20, 0.2, 0.1>>;
  model skate = derive<thrown<Ice>>(), plain = derive<thrown<Plain>>();
  ASSERT_EQ(skate.mistake(), "");
  auto force = skate.function(skate.get<friction_force_of<Ice>>()), rates = skate.function(skate.rhs()),
       of_plain = plain.function(plain.get<friction_force_of<Plain>>()),
       rates_of_plain = plain.function(plain.rhs());
  const VectorXd p{{1, 0.6, 50, 0.5, 0.4}};
  VectorXd state{{0.1, 0.2, 0.3, 0.5, 0.1, -0.2, 0.02, -0.01}};
  const VectorXd f = force(state, p), rate = rates(state, p);
  state(3) *= 0.3, state(5) *= 0.3; // the slip along x
  const VectorXd stretched = of_plain(state, p), rate_of_plain = rates_of_plain(state, p);
  EXPECT_NEAR(f(0), 0.3 * stretched(0), 1e-12);
  EXPECT_NEAR(f(1), stretched(1), 1e-12);
  EXPECT_NEAR(rate(6), rate_of_plain(6), 1e-12);
  EXPECT_NEAR(rate(7), rate_of_plain(7), 1e-12);
}

TEST(contact_words, of_a_torus_and_a_point) {
  using words = thrown<contact<torus_on_plane<C, B::y + 0.1 * B::z, r, 0.1, O, 2 * N::z, B>, elastic<k>,
                               smoothed_over<0.1>, dissipation<v>, stribeck_friction<0.7, mu, 0.1, 0.05>>,
                       contact<point_on_plane<C, Fixed, N::x + N::z>, elastic<k, 2>, smoothed_over<0.3>,
                               viscous_friction<mu>>>;
  built s;
  runtime::contact_data data{.stiffness = s.stiffness, .width = 0.1};
  data.damping = s.approach;
  data.friction = friction_law::stribeck(s.number(0.7), s.coefficient, s.number(0.1), s.number(0.05));
  s.torus_on_plane(s.c, s.b, s.along(s.b, 0, 1, 0.1), s.radius, 0.1, s.o, s.along(s.n, 0, 0, 2), data);
  runtime::contact_data other{.stiffness = s.stiffness, .exponent = 2, .width = 0.3};
  other.friction = friction_law::of_viscosity(s.coefficient);
  s.point_on_plane(s.c, s.fixed, s.along(s.n, 1, 0, 1), other);
  expect_same(derive<words>(), derive(s));
}

TEST(contact_words, of_spheres) {
  using words = thrown<contact<sphere_on_sphere<C, r, Fixed, 0.4, B, N>, elastic<k, 1.5>, smoothed_over<0.1>,
                               coulomb_friction<mu, 0.1>>>;
  built s;
  runtime::contact_data data{.stiffness = s.stiffness, .exponent = 1.5, .width = 0.1};
  data.friction = friction_law::coulomb(s.coefficient, s.number(0.1));
  s.sphere_on_sphere(s.c, s.b, s.radius, s.fixed, s.n, 0.4, data);
  expect_same(derive<words>(), derive(s));
}

TEST(contact_words, with_bristles) {
  using words = thrown<contact<sphere_on_plane<C, r, O, N::z, B>, elastic<k, 1.5>, smoothed_over<0.1>,
                               lugre_friction<0.7, mu, 0.3, 20, 0.2, 0.1>>>;
  built s;
  runtime::contact_data data{.stiffness = s.stiffness, .exponent = 1.5, .width = 0.1};
  data.friction =
      friction_law::lugre(s.number(0.7), s.coefficient, s.number(0.3), s.number(20), s.number(0.2),
                          s.number(0.1), {s.state_variable("z1"), s.state_variable("z2")});
  s.sphere_on_plane(s.c, s.b, s.radius, s.o, s.along(s.n, 0, 0, 1), data);
  model both = derive<words>();
  EXPECT_EQ(both.known()->names[6].view(), "z1_C_O");
  EXPECT_EQ(both.known()->names[7].view(), "z2_C_O");
  expect_same(both, derive(s), 8);

  using others = thrown<contact<sphere_on_sphere<C, r, Fixed, 0.4, B, N>, elastic<k, 1.5>, smoothed_over<0.1>,
                                restitution<0.5, v>, dahl_friction<mu, 30>>>;
  built t;
  runtime::contact_data round{.stiffness = t.stiffness, .exponent = 1.5, .width = 0.1};
  round.restitution = {0.5, t.approach};
  round.friction =
      friction_law::dahl(t.coefficient, t.number(30), {},
                         {t.state_variable("z1"), t.state_variable("z2"), t.state_variable("z3")});
  t.sphere_on_sphere(t.c, t.b, t.radius, t.fixed, t.n, 0.4, round);
  expect_same(derive<others>(), derive(t), 9);
}

TEST(contact_words, of_a_surface) {
  using words =
      thrown<contact<point_on_surface<C, Fixed, N, surface::z - r * sin(surface::x) + 0.2 * surface::y>,
                     elastic<k, 1.5>, smoothed_over<0.3>, coulomb_friction<mu, 0.1>>>;
  built s;
  runtime::contact_data data{.stiffness = s.stiffness, .exponent = 1.5, .width = 0.3};
  data.friction = friction_law::coulomb(s.coefficient, s.number(0.1));
  s.point_on_surface(
      s.c, s.fixed, s.n,
      [&](mechanics::expression x_, mechanics::expression y_, mechanics::expression z_) {
        return z_ - s.radius * sin(x_) + 0.2 * y_;
      },
      data);
  expect_same(derive<words>(), derive(s));
}

struct Ground : inertial_ground<Ground> {};
using load = body<2.5, 0.2 * own::y, inertia<own, 0.4, 0.5, 0.6>>;
struct Crank : pin<Crank, Ground, axis<own::z>, load> {};
struct Slider : prismatic<Slider, Crank, axis<Crank::x>, load> {};

struct Hook : offset<Hook, Ground, 0.3 * Ground::x + 0.8 * Ground::y> {};

template <class... Loads>
struct jointed : kane_system<inertial<Ground>, joints<Crank, Slider>, parameters<k, mu, v>,
                             used_elsewhere<k, mu, v>, loads<Loads...>> {};

template <class First, class Second>
void expect_same_friction() {
  auto first = derive<First>(), second = derive<Second>();
  ASSERT_EQ(first.mistake(), "");
  ASSERT_EQ(second.mistake(), "");
  auto one = first.function(first.rhs()), other = second.function(second.rhs());
  const Eigen::Vector4d state(0.3, -0.7, 1.2, 0.8);
  const Eigen::Vector3d p(2.2, 0.4, 0.05);
  EXPECT_LT((one(state, p) - other(state, p)).norm(), 1e-14 * one(state, p).norm());
}

TEST(friction_words, of_joints) {
  constexpr auto turning = u_of<Crank>;
  constexpr auto sliding = u_of<Slider>;
  expect_same_friction<
      jointed<friction<Crank, k, coulomb_friction<mu, v>>>,
      jointed<
          torque_between<Crank, Ground, -k * mu * turning / sqrt(turning * turning + v * v) * Ground::z>>>();
  constexpr auto relative = sliding / v;
  constexpr auto width = relative * relative / 4 + 0.75;
  constexpr auto peak = 0.3 * tanh(4 * relative) + (mu - 0.3) * relative / (width * width) + 0.1 * sliding;
  expect_same_friction<jointed<friction<Slider, 2 * k, stribeck_friction<mu, 0.3, v, 0.1>>>,
                       jointed<force_between<Slider, Crank, -2 * k * peak * Crank::x>>>();
  using line = straight<Slider, Hook>;
  constexpr auto stretch = position_of<Slider, Hook>;
  constexpr auto rate = dot(stretch, velocity_of<Slider>) / magnitude(stretch);
  expect_same_friction<jointed<friction<line, k, coulomb_friction<mu, v>>>,
                       jointed<force_along<line, k * mu * rate / sqrt(rate * rate + v * v)>>>();
  expect_same_friction<jointed<friction<Crank, 1, viscous_friction<mu>>>,
                       jointed<joint_friction<Crank, mu>>>();
}

// With bristles, compared with loads and dynamics that are written out.
TEST(friction_words, with_bristles) {
  constexpr auto z_ = state_variable<"z">{};
  using line = straight<Slider, Hook>;
  constexpr auto stretch = position_of<Slider, Hook>;
  constexpr auto rate = dot(stretch, velocity_of<Slider>) / magnitude(stretch);
  constexpr auto turning = u_of<Crank>;
  const auto compare = [](model first, model second) {
    ASSERT_EQ(first.mistake(), "");
    ASSERT_EQ(second.mistake(), "");
    auto one = first.function(first.rhs()), other = second.function(second.rhs());
    const VectorXd state = (VectorXd(5) << 0.3, -0.7, 1.2, 0.8, 0.01).finished();
    const Eigen::Vector3d p(2.2, 0.4, 0.05);
    EXPECT_LT((one(state, p) - other(state, p)).norm(), 1e-13 * one(state, p).norm());
  };
  compare(derive<jointed<friction<Crank, k, dahl_friction<mu, 40, v>>>>(),
          derive<extended<jointed<torque_between<Crank, Ground, -k * 40 * z_ * Ground::z>>, states<z_>,
                          dynamics<dot(z_) == turning - 40 * turning * turning /
                                                            sqrt(turning * turning + v * v) * z_ / mu>>>());
  constexpr auto normal = 2 + sin(q_of<Slider>);
  constexpr auto size =
      rate * rate / sqrt(rate * rate + v * v / 1e6) / (0.3 + (mu - 0.3) * exp(-rate * rate / v / v));
  constexpr auto deflects = sqrt(normal) * rate - 40 * size * z_;
  constexpr auto pull = sqrt(normal) * (40 * z_ + 3 / (1 + 3 * size / 4) * deflects) + normal * 0.1 * rate;
  compare(derive<jointed<friction<line, normal, lugre_friction<mu, 0.3, v, 40, 3, 0.1>>>>(),
          derive<extended<jointed<force_along<line, pull>>, states<z_>, dynamics<dot(z_) == deflects>>>());
  EXPECT_EQ((derive<jointed<friction<line, 1, dahl_friction<mu, 40, v>>>>().known()->names[4].view()),
            "z_Slider_Hook");
}

} // namespace
