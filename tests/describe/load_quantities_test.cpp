// The length of a pathway and the forces of loads as expressions: results, parts of other loads and of
// constraints.
#include <kanexpr/contact.hpp>
#include <kanexpr/joints.hpp>
#include <kanexpr/kanexpr.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/symbolic.hpp>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

namespace box_on_a_belt {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr coordinate<"x", meter> x;
constexpr coordinate<"z", meter> z;
constexpr coordinate<"a", radian> a;
constexpr speed<"vx"> vx;
constexpr speed<"vz"> vz;
constexpr speed<"wa"> wa;
constexpr parameter<"k"> k;
constexpr parameter<"c"> c;
constexpr parameter<"mu"> mu;
constexpr auto b = constant<0.02, meter * second / radian>;

struct N : inertial_frame<N> {};
struct O : origin<O, N> {};
struct B : rotated<B, N, a, N::y> {};
struct C : offset<C, O, x * N::x + z * N::z> {};
struct Box : rigid_body<Box, C, B, 2.0, inertia<B, 0.1, 0.2, 0.3>> {};
struct Wall : offset<Wall, O, 2.0 * N::x + 1.0 * N::z> {};

using Rope = straight<C, Wall>;
using Spring = linear_spring<Rope, k, 0.4>;
using Damper = linear_damper<Rope, c>;
using End = stop<Rope, 0.5, 1.5, 80, 0.3>;
using Twist = cubic_spring<given_length<a>, 3, 2>;
using Floor = contact<sphere_on_plane<C, 0.2, O, N::z, B>, elastic<500, 1.5>, smoothed_over<0.01>,
                      dissipation<0.2>, coulomb_friction<mu, 0.1>>;
using Direct = spring<C, O, 5, 0.1>;

struct System
    : kane_system<inertial<N>, coordinates<x, z, a>, speeds<vx, vz, wa>, kinematics<simple>, bodies<Box>,
                  loads<gravity<-9.81 * N::z>, Spring, Damper, End, Twist, Floor, Direct>> {};

/// The length of the rope in a potential energy, and the normal force of the floor as that of a brake.
struct braked
    : kane_system<inertial<N>, coordinates<x, z, a>, speeds<vx, vz, wa>, kinematics<simple>, bodies<Box>,
                  loads<potential_energy<k*(length_of<Rope> - 0.4) * (length_of<Rope> - 0.4) / 2>, Floor,
                        torque<B, -(b* normal_force_of<Floor>)*wa * N::y>,
                        force<C, -0.1 * tension_of<Damper> * N::x>, Damper>> {};

/// The box on a rope that does not stretch.
struct tethered : kane_system<inertial<N>, coordinates<x, z, a>, speeds<vx, vz, wa>, kinematics<simple>,
                              bodies<Box>, configuration_constraints<length_of<Rope> == 1.0>> {};
struct tethered_by_hand
    : kane_system<inertial<N>, coordinates<x, z, a>, speeds<vx, vz, wa>, kinematics<simple>, bodies<Box>,
                  configuration_constraints<magnitude(position_of<Wall, C>) == 1.0>> {};

} // namespace box_on_a_belt

namespace {

using namespace box_on_a_belt;
using Eigen::Vector3d;
using Eigen::VectorXd;

VectorXd some_state(std::mt19937_64& source) {
  std::uniform_real_distribution<double> unit(0, 1);
  VectorXd all(6);
  all << 0.8 + unit(source), 0.1 + 0.15 * unit(source), unit(source), unit(source) - 0.5, unit(source) - 0.5,
      unit(source);
  return all;
}
const Vector3d given(30, 4, 0.3); // k, c, mu

TEST(load_quantities, follow_their_laws) {
  model m = derive<System>();
  ASSERT_EQ(m.mistake(), "");
  auto length = m.function(m.get<length_of<Rope>>()),
       spring_tension = m.function(m.get<tension_of<Spring>>()),
       damping = m.function(m.get<tension_of<Damper>>()), stopping = m.function(m.get<tension_of<End>>()),
       twist = m.function(m.get<tension_of<Twist>>()), direct = m.function(m.get<tension_of<Direct>>()),
       normal = m.function(m.get<normal_force_of<Floor>>()),
       rubbing = m.function(m.get<friction_force_of<Floor>>());
  std::mt19937_64 source(4);
  for (int i = 0; i < 20; ++i) {
    const VectorXd s = some_state(source);
    const Eigen::Vector2d d(2 - s[0], 1 - s[1]), v(s[3], s[4]);
    const double l = d.norm(), rate = -d.dot(v) / l;
    EXPECT_NEAR(length(s, given)(0), l, 1e-14);
    EXPECT_NEAR(spring_tension(s, given)(0), 30 * (l - 0.4), 1e-12);
    EXPECT_NEAR(damping(s, given)(0), 4 * rate, 1e-12);
    const double beyond = l - 1.5;
    if (beyond > 1e-3) {
      EXPECT_NEAR(stopping(s, given)(0), 80 * (beyond - 0.0005) * (1 + 0.3 * rate), 1e-11);
    }
    if (beyond < 0 && l > 0.5) {
      EXPECT_EQ(stopping(s, given)(0), 0);
    }
    EXPECT_NEAR(twist(s, given)(0), 3 * s[2] + 2 * std::pow(s[2], 3), 1e-12);
    EXPECT_NEAR(direct(s, given)(0), 5 * (s.head(2).norm() - 0.1), 1e-12);
    const double deep = 0.2 - s[1];
    const double pressed = 500 * std::pow(deep, 1.5) * (1 - 0.2 * s[4]);
    if (deep > 0.01) {
      EXPECT_NEAR(normal(s, given)(0), pressed, 1e-11);
      const double slip = s[3] - 0.2 * s[5];
      const VectorXd f = rubbing(s, given);
      EXPECT_NEAR(f[0], -0.3 * pressed * slip / std::hypot(slip, 0.1), 1e-11);
      EXPECT_EQ(f[1], 0);
      EXPECT_EQ(f[2], 0);
    }
    if (deep < -0.01) {
      EXPECT_EQ(normal(s, given)(0), 0);
    }
  }
}

// The forces of all loads on the box are its mass times its acceleration.
TEST(load_quantities, add_up_to_the_acceleration) {
  model m = derive<System>();
  auto whole = m.function(
      m.get<(tension_of<Spring> + tension_of<Damper> + tension_of<End>)*normalized(position_of<Wall, C>) -
            tension_of<Direct> * normalized(position_of<C, O>) + normal_force_of<Floor> * N::z +
            friction_force_of<Floor> - 2.0 * acceleration_of<C> - 2.0 * 9.81 * N::z>());
  std::mt19937_64 source(4);
  for (int i = 0; i < 20; ++i) {
    const VectorXd s = some_state(source), rest = whole(s, given);
    EXPECT_LT(rest.norm(), 1e-11);
  }
}

TEST(load_quantities, compiled) {
  using kanexpr::function;
  model m = derive<System>();
  auto normal = m.function(m.get<normal_force_of<Floor>>()),
       damping = m.function(m.get<tension_of<Damper>>());
  std::mt19937_64 source(4);
  for (int i = 0; i < 5; ++i) {
    const VectorXd s = some_state(source);
    const kanexpr::state<System> at{{x, s[0]}, {z, s[1]}, {a, s[2]}, {vx, s[3]}, {vz, s[4]}, {wa, s[5]}};
    const kanexpr::parameter_values<System> p{{k, 30}, {c, 4}, {mu, 0.3}};
    const auto [pressed, pulled] = function<System, normal_force_of<Floor>, tension_of<Damper>>{}(at, p);
    EXPECT_EQ(pressed, normal(s, given)(0));
    EXPECT_EQ(pulled, damping(s, given)(0));
  }
}

TEST(load_quantities, in_other_loads_and_constraints) {
  model m = derive<braked>();
  ASSERT_EQ(m.mistake(), "");
  auto torque = m.function(m.get(mechanics::quantity::active_forces));
  auto normal = m.function(m.get<normal_force_of<Floor>>()),
       damping = m.function(m.get<tension_of<Damper>>());
  auto rubbing = m.function(m.get<friction_force_of<Floor>>());
  std::mt19937_64 source(4);
  for (int i = 0; i < 20; ++i) {
    const VectorXd s = some_state(source), f = torque(s, given), friction = rubbing(s, given);
    const Eigen::Vector2d d(2 - s[0], 1 - s[1]);
    EXPECT_NEAR(f[2], -0.02 * s[5] * normal(s, given)(0) - 0.2 * friction[0], 1e-12);
    const double pull = 30 * (d.norm() - 0.4) + damping(s, given)(0);
    EXPECT_NEAR(f[0], pull * d[0] / d.norm() + friction[0] - 0.1 * damping(s, given)(0), 1e-12);
  }
  model bound = derive<tethered>(), by_hand = derive<tethered_by_hand>();
  ASSERT_EQ(bound.mistake(), "");
  auto first = bound.function(bound.rhs()), second = by_hand.function(by_hand.rhs());
  const VectorXd s = some_state(source);
  EXPECT_LT((first(s) - second(s)).norm(), 1e-13 * second(s).norm());
}

TEST(load_quantities, have_units) {
  model m = derive<System>();
  const auto unit = [](const mechanics::possible_unit& u) {
    return u ? std::string(text_of(*u).view()) : "unknown";
  };
  EXPECT_EQ(unit(m.unit_of<length_of<Rope>>()), "m");
  EXPECT_EQ(unit(m.unit_of<tension_of<Spring>>()), "N");
  EXPECT_EQ(unit(m.unit_of<normal_force_of<Floor>>()), "N");
  EXPECT_EQ(unit(m.unit_of<friction_force_of<Floor>>()), "N");
  EXPECT_EQ(unit(m.units().of("k")), "N/m");
  EXPECT_EQ(unit(derive<braked>().units().of("k")), "N/m");
}

// The same forces from a builder.
TEST(load_quantities, of_a_builder) {
  const auto with_force = [](int contact, std::string& mistake) {
    runtime::builder b("N");
    const auto q = b.coordinate("z"), u = b.speed("vz");
    b.kinematic_equation(b.dot(q) - u);
    const auto floor = b.origin("O"), center = b.offset("C", floor, b.along(b.inertial_frame(), 0, 0, q));
    b.particle("Ball", center, b.number(1));
    runtime::contact_data data{.stiffness = 500, .exponent = 1.5, .width = 0.01};
    data.damping = 0.2;
    b.point_on_plane(center, floor, b.along(b.inertial_frame(), 0, 0, 1), data);
    mechanics::known_motion known(b.mechanism());
    symbolic::matrix force(b.graph(), 1, 1);
    force.entries[0] = b.normal_force_of(contact, known);
    mistake = b.mistake().view();
    return derive(b).function(force)(Eigen::Vector2d(-0.1, 0.3))(0);
  };
  std::string mistake;
  EXPECT_NEAR(with_force(1, mistake), 500 * std::pow(0.1, 1.5) * (1 - 0.2 * 0.3), 1e-12);
  EXPECT_EQ(mistake, "");
  with_force(2, mistake);
  EXPECT_EQ(mistake, "the force of contact 2 is requested, but the number of contacts is 1");
}

} // namespace
