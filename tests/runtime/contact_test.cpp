// builds: clang++
// Contacts and friction, compared with closed forms, and their energy on random motions.
#include <kanexpr/lower/complex_math.hpp>
#include <kanexpr/mechanics/loads/contact.hpp>
#include <kanexpr/mechanics/loads/friction_law.hpp>
#include <kanexpr/mechanics/loads/restitution.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/runtime/linearization.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>
#include <kanexpr/units/si.hpp>
#include <kanexpr/units/unit_text.hpp>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>
#include <string>
#include <vector>

namespace {

namespace mechanics = kanexpr::mechanics;
namespace symbolic = kanexpr::symbolic;
using Eigen::VectorXd;
using kanexpr::derive;
using kanexpr::model;
using kanexpr::runtime::builder;
using kanexpr::runtime::contact_data;
using kanexpr::runtime::frame_id;
using kanexpr::runtime::point_id;
using mechanics::friction_law;
using symbolic::expression;

/// The values of some expressions of one number x.
template <class Form>
std::vector<double> values_at(double x, const Form& form) {
  struct bob : builder {
    bob() : builder("N") {
      const expression q = coordinate("q");
      kinematic_equation(dot(q) - speed("u"));
      particle("Bob", offset("P", origin("O"), along(inertial_frame(), q, 0, 0)), number(1));
    }
  };
  bob b;
  const expression q = b.mechanism().coordinates[0];
  symbolic::matrix all(b.graph(), 0, 1);
  for (const expression& e : form(b, q)) {
    all.entries.push(e);
    ++all.rows;
  }
  model m = derive(b);
  auto function = m.function(all);
  const auto& found = function(Eigen::Vector2d(x, 0));
  return {found.data(), found.data() + found.size()};
}

double stribeck(double v) {
  const double s = v / 0.02, at = 0.25 * s * s + 0.75;
  return 0.3 * std::tanh(4 * s) + (0.5 - 0.3) * s / (at * at) + 0.07 * v;
}

TEST(friction, laws_have_their_closed_forms) {
  const auto laws = [](builder& b, expression v) -> std::vector<expression> {
    const auto coulomb = friction_law::coulomb(b.number(0.4), b.number(0.02));
    const auto peaked = friction_law::stribeck(b.number(0.5), b.number(0.3), b.number(0.02), b.number(0.07));
    const auto viscous = friction_law::of_viscosity(b.number(0.07));
    const expression second = symbolic::differentiate(v * peaked.over_slip(v * v), v);
    return {coulomb.coefficient(v),
            v * coulomb.over_slip(v * v),
            peaked.coefficient(v),
            v * peaked.over_slip(v * v),
            viscous.coefficient(v),
            viscous.over_slip(v * v),
            symbolic::differentiate(peaked.coefficient(v), v),
            second,
            symbolic::differentiate(second, v)};
  };
  for (double v : {-0.3, -0.02, -0.0051, -0.00049, -1e-5, 0.0, 1e-9, 4e-4, 0.00051, 0.003, 0.02, 0.5}) {
    const std::vector<double> found = values_at(v, laws);
    EXPECT_NEAR(found[0], 0.4 * v / std::hypot(v, 0.02), 1e-15) << v;
    EXPECT_NEAR(found[1], found[0], 1e-15);
    EXPECT_NEAR(found[2], stribeck(v), 1e-15) << v;
    EXPECT_NEAR(found[3], stribeck(v), 1e-15) << v;
    EXPECT_NEAR(found[4], 0.07 * v, 1e-17);
    EXPECT_EQ(found[5], 0.07);
    EXPECT_NEAR(found[6], found[7], 1e-11 * std::abs(found[6])) << v; // 79 at rest
    EXPECT_TRUE(std::isfinite(found[8]));
  }
}

/// Elastic force, energy and their derivatives by the penetration, with k = 1000, w = 0.01.
std::vector<double> pressed(double penetration, double exponent) {
  return values_at(penetration, [&](builder& b, expression x) -> std::vector<expression> {
    const mechanics::contact_law law{b.number(1000), mechanics::contact_exponent(b.number(exponent)),
                                     b.number(0.01), b.number(2)};
    const expression force = law.elastic_force(x), slope = symbolic::differentiate(force, x);
    return {force,
            law.energy(x),
            symbolic::differentiate(law.energy(x), x),
            slope,
            symbolic::differentiate(slope, x),
            law.dissipation(x)};
  });
}

TEST(contact, has_no_force_at_a_distance_and_the_elastic_one_beyond_the_width) {
  for (const double n : {1.0, 1.5, 2.2}) {
    for (const double gap : {0.01, 0.0101, 0.3, 1e6}) {
      const std::vector<double> found = pressed(-gap, n);
      for (int i = 0; i < 5; ++i) EXPECT_EQ(found[static_cast<std::size_t>(i)], 0) << gap << " " << i;
    }
    for (const double depth : {0.01, 0.03, 2.0}) {
      const std::vector<double> found = pressed(depth, n);
      EXPECT_NEAR(found[0], 1000 * std::pow(depth, n), 1e-12 * found[0]);
      EXPECT_NEAR(found[3], 1000 * n * std::pow(depth, n - 1), 1e-12 * found[3]);
    }
  }
}

TEST(contact, is_smooth) {
  for (const double n : {1.0, 1.5, 2.2}) {
    std::vector<double> before = pressed(-0.012, n);
    constexpr double step = 1e-5;
    for (int i = -1199; i < 1500; ++i) {
      const std::vector<double> found = pressed(i * step, n);
      EXPECT_GE(found[0], before[0]);
      EXPECT_NEAR(found[2], found[0], 1e-12 * found[0]);          // the force is the derivative of the energy
      EXPECT_LT(std::abs(found[3] - before[3]), 6e5 * step) << i; // no kink
      EXPECT_TRUE(std::isfinite(found[4]));
      before = found;
    }
  }
}

TEST(contact, never_pulls_and_only_takes_energy) {
  double before = -1;
  for (int i = -3000; i < 3000; ++i) {
    const double rate = 1e-3 * i, factor = pressed(rate, 1)[5]; // c = 2
    EXPECT_GE(factor, before < 0 ? 0 : before);
    EXPECT_GE((factor - 1) * rate, 0);
    if (rate >= -0.375) {
      EXPECT_NEAR(factor, 1 + 2 * rate, 1e-15 * (1 + std::abs(factor)));
    }
    if (rate <= -0.625) {
      EXPECT_EQ(factor, 0);
    }
    before = factor;
  }
  EXPECT_EQ(pressed(0, 1)[5], 1);
}

TEST(contact, damping_of_restitution_is_that_of_the_closed_form) {
  for (const double e : {0.5, 0.6, 0.75, 0.9, 0.99}) {
    const double x = mechanics::damping_of_restitution(e);
    EXPECT_NEAR(std::log1p(x) - x, std::log1p(-e * x) + e * x, 1e-15);
  }
  static_assert(mechanics::damping_of_restitution(0.5) > 1.43 && mechanics::damping_of_restitution(1) == 0);
  EXPECT_EQ(mechanics::damping_of_restitution(1.5), 0);
}

VectorXd rk4_step(kanexpr::runtime::interpreted<double>& rhs, const VectorXd& x, double h) {
  const VectorXd k1 = rhs(x), k2 = rhs(x + h / 2 * k1), k3 = rhs(x + h / 2 * k2), k4 = rhs(x + h * k3);
  return x + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
}

contact_data lossless() { return {.stiffness = 2e4, .exponent = 1.5, .width = 0.002}; }

/// A ball in a vertical plane, or a particle.
struct ball : builder {
  frame_id n = inertial_frame(), spin{};
  point_id ground{}, center{};
  explicit ball(double weight) : builder("N") {
    const expression x = coordinate("x"), z = coordinate("z"), a = coordinate("a");
    for (const expression& q : {x, z, a}) kinematic_equation(dot(q) - speed("u_" + symbolic::print(q)));
    ground = origin("O");
    spin = rotated("B", n, a, along(n, 0, 1, 0));
    center = offset("C", ground, along(n, x, 0, z));
    rigid_body("Ball", center, spin, number(2), inertia(spin, 0.008, 0.008, 0.008)); // 2/5 m r², r = 0.1
    gravity(along(n, 0, 0, number(-weight)));
  }
  mechanics::vector up() { return along(n, 0, 0, 1); }
};

TEST(contact, measured_restitution_is_the_requested_one) {
  for (const double e : {0.05, 0.2, 0.5, 0.8, 1.0}) {
    ball b(0.0);
    contact_data data = lossless();
    data.restitution = {e, 0.7};
    b.sphere_on_plane(b.center, b.spin, 0.1, b.ground, b.up(), data);
    model m = derive(b);
    ASSERT_EQ(m.mistake(), "");
    auto rhs = m.function(m.rhs());
    VectorXd x(6);
    x << 0, 0.1021, 0, 0, -0.7, 0;
    for (int step = 0; step < 40000 && !(x[1] > 0.102 && x[4] > 0); ++step) x = rk4_step(rhs, x, 2e-5);
    EXPECT_NEAR(x[4] / 0.7, e, 1e-8);
  }
}

// The distance until rest is the integral of √(v² + ε²)/(μ g), v²/(2 μ g) for ε = 0.
TEST(friction, of_a_sliding_block) {
  constexpr double mu = 0.3, eps = 0.02, v = 1.5, g = 9.81;
  ball b(g);
  contact_data data{.stiffness = 1e4, .width = 1e-3};
  data.friction = friction_law::coulomb(b.number(mu), b.number(eps));
  b.point_on_plane(b.center, b.ground, b.up(), data);
  model m = derive(b);
  ASSERT_EQ(m.mistake(), "");
  auto rhs = m.function(m.rhs());
  VectorXd x(6);
  x << 0, -2 * g / 1e4, 0.2, v, 0, 0.4; // in equilibrium vertically; a point transmits no torque
  for (int step = 0; step < 2000; ++step) x = rk4_step(rhs, x, 1e-3);
  const double exact = (v * std::hypot(v, eps) + eps * eps * std::asinh(v / eps)) / (2 * mu * g);
  EXPECT_NEAR(x[0], exact, 1e-9);
  EXPECT_NEAR(x[0], v * v / (2 * mu * g), 1e-3 * x[0]);
  EXPECT_NEAR(x[5], 0.4, 1e-14);
}

// A billiard ball slides until its speed is 5/7 of the initial one, at 2 v/(7 μ g); then it rolls.
TEST(friction, of_a_ball_that_begins_to_roll) {
  constexpr double mu = 0.2, v = 1.4, g = 9.81;
  ball b(g);
  contact_data data{.stiffness = 1e4, .width = 1e-3};
  data.restitution = {0.5, 0.1}; // the slip speed is 1 mm/s
  data.friction = friction_law::coulomb(b.number(mu), {});
  b.sphere_on_plane(b.center, b.spin, 0.1, b.ground, b.up(), data);
  model m = derive(b);
  ASSERT_EQ(m.mistake(), "");
  auto rhs = m.function(m.rhs());
  VectorXd x(6);
  x << 0, 0.1 - 2 * g / 1e4, 0, v, 0, 0;
  const double onset = 2 * v / (7 * mu * g);
  double at_half = 0;
  for (int step = 0; step < 3000; ++step) {
    x = rk4_step(rhs, x, onset / 1500);
    if (step == 749) at_half = x[3];
  }
  EXPECT_NEAR(at_half, v - mu * g * onset / 2, 1e-5);
  EXPECT_NEAR(x[3], 5 * v / 7, 1e-6);
  EXPECT_NEAR(x[3], 0.1 * x[5], 1e-6);
}

TEST(friction, along_a_cable) {
  ball b(0.0);
  const auto law = friction_law::stribeck(b.number(0.5), b.number(0.3), b.number(0.02), b.number(0.07));
  b.friction_along(b.straight(b.center, b.ground), b.number(6), law);
  model m = derive(b);
  ASSERT_EQ(m.mistake(), "");
  VectorXd x(6);
  x << 0.3, 0.4, 0, 0.05, -0.02, 0;
  const VectorXd rates = m.function(m.rhs())(x);
  const double pull = 6 * stribeck(0.6 * 0.05 - 0.8 * 0.02) / 2; // by the mass of 2 kg
  EXPECT_NEAR(rates[3], -0.6 * pull, 1e-14);
  EXPECT_NEAR(rates[4], -0.8 * pull, 1e-14);
  ball other(0.0);
  other.friction_along(other.straight(other.center, other.ground), other.number(6),
                       friction_law::coulomb(other.number(0.4), {}));
  EXPECT_EQ(derive(other).mistake(), "a friction along a pathway has no slip speed");
}

TEST(friction, rolling_resistance_stops_a_ball) {
  constexpr double g = 9.81, lever = 0.002;
  ball b(g);
  contact_data data{.stiffness = 1e4, .width = 1e-3};
  data.friction = friction_law::coulomb(b.number(0.5), b.number(0.05));
  data.rolling = {b.number(lever), b.number(1e-3)};
  b.sphere_on_plane(b.center, b.spin, 0.1, b.ground, b.up(), data);
  model m = derive(b);
  ASSERT_EQ(m.mistake(), "");
  auto rhs = m.function(m.rhs());
  VectorXd x(6);
  x << 0, 0.1 - 2 * g / 1e4, 0, 0.5, 0, 5;
  for (int step = 0; step < 100; ++step) x = rk4_step(rhs, x, 1e-3);
  const double before = x[3];
  for (int step = 0; step < 400; ++step) x = rk4_step(rhs, x, 1e-3);
  // m v' = −F and 2/5 m r v' = F r − b m g, so v' = −5/7 g b/r
  EXPECT_NEAR(x[3] - before, -5.0 / 7 * g * lever / 0.1 * 0.4, 1e-7);
}

// 2/5 m r² ω' = −b m g about the normal.
TEST(friction, spinning_resistance_stops_a_top) {
  constexpr double g = 9.81, lever = 0.001;
  builder b("N");
  const auto z = b.coordinate("z"), q = b.coordinate("q"), v = b.speed("v"), w = b.speed("w");
  b.kinematic_equation(b.dot(z) - v), b.kinematic_equation(b.dot(q) - w);
  const auto n = b.inertial_frame(), body = b.rotated("B", n, q, b.along(n, 0, 0, 1));
  const auto floor = b.origin("O"), center = b.offset("C", floor, b.along(n, 0.0, 0.0, z));
  b.rigid_body("Ball", center, body, b.number(2), b.inertia(body, 0.008, 0.008, 0.008));
  b.gravity(b.along(n, 0, 0, -g));
  contact_data data{.stiffness = 1e4, .width = 1e-3};
  data.spinning = {b.number(lever), b.number(1e-3)};
  b.sphere_on_plane(center, body, 0.1, floor, b.along(n, 0, 0, 1), data);
  model m = derive(b);
  ASSERT_EQ(m.mistake(), "");
  auto rhs = m.function(m.rhs());
  VectorXd x(4);
  x << 0.1 - 2 * g / 1e4, 0, 0, 7;
  for (int step = 0; step < 1000; ++step) x = rk4_step(rhs, x, 1e-3);
  EXPECT_NEAR(x[3], 7 - lever * 2 * g / 0.008, 1e-7);
  for (int step = 0; step < 5000; ++step) x = rk4_step(rhs, x, 1e-3);
  EXPECT_LT(std::abs(x[3]), 1e-6);

  builder other("N");
  const auto height = other.coordinate("z"), speed = other.speed("v");
  other.kinematic_equation(other.dot(height) - speed);
  const auto up = other.along(other.inertial_frame(), 0, 0, 1);
  const auto o = other.origin("O"), p = other.offset("P", o, height * up);
  other.particle("Bob", p, other.number(1));
  contact_data turning{.stiffness = 1e4, .width = 1e-3};
  turning.spinning = {other.number(lever), other.number(1e-4)};
  other.point_on_plane(p, o, up, turning);
  EXPECT_EQ(derive(other).mistake(),
            "the contact between P and O has a resistance to rolling or spinning, but "
            "a point does not turn");
}

/// A free body and a moving plate or a second ball, with one contact between them.
struct two_bodies : builder {
  std::vector<expression> q, u;
  frame_id n = inertial_frame(), body{}, plate{};
  point_id center{}, place{};

  two_bodies() : builder("N") {
    for (int i = 0; i < 12; ++i) {
      q.push_back(coordinate("q" + std::to_string(i)));
      u.push_back(speed("u" + std::to_string(i)));
      kinematic_equation(dot(q.back()) - u.back());
    }
    const point_id o = origin("O");
    body = body_fixed("B", n, "zxy", q[3], q[4], q[5]);
    center = offset("C", o, along(n, q[0], q[1], q[2]));
    rigid_body("Body", center, body, number(1.3), inertia(body, 0.03, 0.05, 0.04));
    plate = body_fixed("A", n, "xyz", q[9], q[10], q[11]);
    place = offset("Q", o, along(n, q[7], q[8], q[6]));
    rigid_body("Plate", offset("D", place, along(plate, 0.1, 0, 0)), plate, number(2),
               inertia(plate, 0.2, 0.3, 0.4));
  }
};

/// `carried` is a sphere whose center moves in the frame with which it turns.
enum class shape { point, sphere, torus, ball, hill, carried };

void touch(two_bodies& b, shape s, const contact_data& data) {
  const auto normal = b.along(b.plate, 0.1, 0.2, 0.9), axis = b.along(b.body, 0, 1, 0.1);
  switch (s) {
  case shape::point: return b.point_on_plane(b.center, b.place, normal, data);
  case shape::sphere: return b.sphere_on_plane(b.center, b.body, 0.4, b.place, normal, data);
  case shape::torus: return b.torus_on_plane(b.center, b.body, axis, 0.3, 0.1, b.place, normal, data);
  case shape::hill:
    return b.point_on_surface(
        b.center, b.place, b.plate,
        [](expression x, expression y, expression z) { return 2 * z - 0.3 * sin(2 * x) + 0.4 * y * y; },
        data);
  case shape::carried: {
    const point_id moving = b.offset("P", b.center, b.along(b.body, 0.3 * b.q[0], 0.1 * sin(b.q[4]), 0));
    return b.sphere_on_plane(moving, b.body, 0.4, b.place, normal, data);
  }
  case shape::ball: return b.sphere_on_sphere(b.center, b.body, 0.4, b.place, b.plate, 0.3, data);
  }
}

contact_data rough(builder& b) {
  contact_data data{.stiffness = 300, .exponent = 1.5, .width = 0.05};
  data.restitution = {0.4, 0.6};
  data.friction = friction_law::stribeck(b.number(0.6), b.number(0.4), b.number(0.1), b.number(0.02));
  return data;
}

/// A state in which the bodies may touch.
VectorXd state_near_contact(shape s, std::mt19937& random) {
  std::uniform_real_distribution<double> between(-1, 1);
  VectorXd x = VectorXd::NullaryExpr(24, [&] { return between(random); });
  x.head(2) *= 0.2, x.segment(6, 3) *= 0.2, x.segment(9, 3) *= 0.3;
  const double reach = s == shape::point || s == shape::hill ? 0 : s == shape::ball ? 0.65 : 0.35;
  x[2] = x[6] + reach + 0.15 * x[2];
  return x;
}

expression rate_of(model& m, expression value) {
  const symbolic::matrix rates = m.rhs();
  expression sum = value.number(symbolic::exactly(0));
  int row = 0;
  for (const auto* list : {&m.mechanism().coordinates, &m.mechanism().speeds})
    for (const expression& e : *list) sum += symbolic::differentiate(value, e) * rates.entries[row++];
  return sum;
}

/// The rates of energy, linear and angular momentum, and the potential energy.
symbolic::matrix balances_of(builder& b, model& m) {
  symbolic::matrix all(b.graph(), 8, 1);
  const expression potential = m.get(mechanics::quantity::potential_energy).entries[0];
  all.entries[0] = rate_of(m, m.get(mechanics::quantity::kinetic_energy).entries[0] + potential);
  for (int i = 0; i < 3; ++i) {
    all.entries[1 + i] = rate_of(m, m.get(mechanics::quantity::linear_momentum).entries[i]);
    all.entries[4 + i] = rate_of(m, m.get(mechanics::quantity::angular_momentum).entries[i]);
  }
  all.entries[7] = potential;
  return all;
}

TEST(contact, creates_neither_energy_nor_momentum_whatever_the_motion) {
  for (const shape s : {shape::point, shape::sphere, shape::torus, shape::ball, shape::hill, shape::carried})
    for (const bool is_rough : {false, true}) {
      two_bodies b;
      contact_data data = rough(b);
      if (!is_rough) data = {.stiffness = 300, .exponent = 1.5, .width = 0.05};
      if (is_rough && s != shape::point && s != shape::hill) {
        data.rolling = {b.number(0.01), b.number(0.1)};
        data.spinning = {b.number(0.02), b.number(0.2)};
      }
      touch(b, s, data);
      model m = derive(b);
      ASSERT_EQ(m.mistake(), "");
      auto function = m.function(balances_of(b, m));
      std::mt19937 random(5);
      int touching = 0;
      for (int i = 0; i < 1000; ++i) {
        const VectorXd x = state_near_contact(s, random);
        const auto& found = function(x);
        if (found(7, 0) > 0.5) ++touching; // the elastic energy
        if (is_rough) {
          EXPECT_LE(found(0, 0), 1e-11);
        } else {
          EXPECT_NEAR(found(0, 0), 0, 1e-11);
        }
        if (s != shape::carried) { // whose motion in the body another force would have to cause
          EXPECT_LT(Eigen::VectorXd(found).segment(1, 6).norm(), 1e-11);
        }
      }
      EXPECT_GT(touching, 100);
    }
}

/// The rates of the speeds of a body that is touched, by Lagrange's method.
struct fallen : builder {
  explicit fallen(bool by_lagrange) : builder("N") {
    const expression x = coordinate("x"), z = coordinate("z"), a = coordinate("a");
    if (by_lagrange) rates_as_speeds();
    if (!by_lagrange)
      for (const expression& q : {x, z, a}) kinematic_equation(dot(q) - speed("u_" + symbolic::print(q)));
    const frame_id n = inertial_frame(), disc = rotated("B", n, a, along(n, 0, 1, 0));
    const point_id o = origin("O"), c = offset("C", o, along(n, x, 0, z));
    rigid_body("Disc", offset("G", c, along(disc, 0.02, 0, 0.01)), disc, number(2),
               inertia(disc, 0.01, 0.02, 0.03));
    gravity(along(n, 0, 0, -9.81));
    contact_data data{.stiffness = 2e3, .exponent = 1.5, .width = 0.02};
    data.restitution = {0.6, 1.0};
    data.friction = friction_law::coulomb(number(0.4), number(0.1));
    torus_on_plane(c, disc, along(disc, 0, 1, 0), 0.15, 0.05, o, along(n, 0, 0.1, 1), data);
  }
};

TEST(contact, is_the_same_by_lagrange_and_by_kane) {
  model kane = derive(fallen(false)), lagrange = derive(fallen(true));
  ASSERT_EQ(kane.mistake(), "");
  ASSERT_EQ(lagrange.mistake(), "");
  auto first = kane.function(kane.rhs()), second = lagrange.function(lagrange.rhs());
  for (const double z : {0.15, 0.19, 0.2, 0.21, 0.3}) {
    VectorXd x(6);
    x << 0.4, z, 0.8, 0.3, -0.5, 2;
    EXPECT_LT((first(x) - second(x)).norm(), 1e-12 * first(x).norm());
  }
}

// First and second derivatives, compared with complex steps: without contact, while it closes, and in
// contact.
TEST(contact, derivatives_are_exact_and_finite) {
  using complex = std::complex<double>;
  model m = derive(fallen(false));
  auto rhs = m.function<complex>(m.rhs());
  auto jacobian = m.function<complex>(m.get(mechanics::quantity::state_jacobian));
  auto hessian = m.function(m.get(mechanics::quantity::weighted_hessian));
  VectorXd weights(6);
  weights << 0, 0, 0, 0.7, -0.4, 0.9;
  for (const double z : {0.15, 0.19, 0.2, 0.205, 0.3, 1e3}) {
    VectorXd x(6);
    x << 0.4, z, 0.8, 0.3, -0.5, 2;
    const Eigen::MatrixXd second = hessian(0, x, VectorXd(), VectorXd(), weights);
    EXPECT_TRUE(second.allFinite());
    const Eigen::MatrixXd first = Eigen::MatrixXcd(jacobian(Eigen::VectorXcd(x))).real();
    EXPECT_TRUE(first.allFinite());
    for (int j = 0; j < 6; ++j) {
      Eigen::VectorXcd aside = x;
      aside[j] += complex(0, 1e-30);
      const VectorXd column = Eigen::VectorXcd(rhs(aside)).imag() / 1e-30;
      EXPECT_LT((column - first.col(j)).norm(), 1e-10 * (1 + first.norm())) << z;
      const VectorXd bent = (Eigen::MatrixXcd(jacobian(aside)).imag() / 1e-30).transpose() * weights;
      EXPECT_LT((bent - second.col(j)).norm(), 1e-10 * (1 + second.norm())) << z;
    }
  }
}

// The slip is 10⁵ times the speed at which friction is greatest.
TEST(contact, derivatives_are_finite_in_single_precision) {
  two_bodies b;
  contact_data data = rough(b);
  data.friction = friction_law::stribeck(b.number(0.6), b.number(0.4), b.number(1e-3), b.number(0.02));
  touch(b, shape::sphere, data);
  model m = derive(b);
  auto jacobian = m.function<float>(m.get(mechanics::quantity::state_jacobian));
  std::mt19937 random(8);
  Eigen::VectorXf x = state_near_contact(shape::sphere, random).cast<float>();
  x.tail(12) *= 10;
  EXPECT_TRUE(Eigen::MatrixXf(jacobian(x)).allFinite());
}

TEST(contact, units_follow_from_those_of_the_ball) {
  using namespace kanexpr::units::si;
  ball b(0.0);
  const expression k = b.parameter("k"), w = b.parameter("w"), r = b.parameter("r", meter),
                   v = b.parameter("v"), mu = b.parameter("mu"), lever = b.parameter("b"),
                   spin = b.parameter("s");
  contact_data data{.stiffness = k, .exponent = 1.5, .width = w};
  data.restitution = {0.5, v};
  data.friction = friction_law::coulomb(mu, {});
  data.rolling = {lever, spin};
  b.sphere_on_plane(b.center, b.spin, r, b.ground, b.up(), data);
  ASSERT_EQ(std::string((b.check)().view()), "");
  const auto unit = [&](const char* of) { return std::string(text_of(b.units().of(of)).view()); };
  EXPECT_EQ(unit("k"), "N/m^(3/2)");
  EXPECT_EQ(unit("w"), "m");
  EXPECT_EQ(unit("v"), "m/s");
  EXPECT_EQ(unit("mu"), "1");
  EXPECT_EQ(unit("b"), "m");
  EXPECT_EQ(unit("s"), "rad/s");
}

TEST(contact, torus_touches_at_its_lowest_point) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> between(-1, 1);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector3d normal = Eigen::Vector3d::Random().normalized(),
                          axis = Eigen::Vector3d::Random().normalized(),
                          line = Eigen::Vector3d::NullaryExpr([&] { return between(random); });
    builder b("N");
    const auto given = [&](const Eigen::Vector3d& v) {
      return mechanics::components(b.number(v[0]), b.number(v[1]), b.number(v[2]));
    };
    mechanics::contact_geometry g;
    g.shapes = mechanics::contact_shapes::torus_on_plane;
    g.against = static_cast<int>(b.origin("O"));
    const auto n = builder::inertial_frame();
    g.point = static_cast<int>(b.offset("P", point_id{g.against}, b.along(n, line[0], line[1], line[2])));
    g.frame = g.other = g.axis_frame = static_cast<int>(n);
    g.normal = given(normal), g.axis = given(axis);
    g.radius = b.number(0.1), g.other_radius = b.number(0.4);
    const mechanics::touching t = g.at(b.mechanism());
    const auto number = [](expression e) { return e.owner().number_at(e.node()).value(); };
    const Eigen::Vector3d side = axis.cross(normal).normalized(), other = axis.cross(side);
    double least = 1e9;
    for (int k = 0; k < 4000; ++k) {
      const double angle = k * static_cast<double>(EIGEN_PI) / 2000;
      const Eigen::Vector3d on_circle = 0.4 * (std::cos(angle) * side + std::sin(angle) * other);
      least = std::min(least, normal.dot(line + on_circle) - 0.1);
    }
    EXPECT_NEAR(-number(t.penetration), least, 1e-6);
    const Eigen::Vector3d arm(number(t.arm.x), number(t.arm.y), number(t.arm.z));
    EXPECT_NEAR(normal.dot(line + arm), -number(t.penetration), 1e-14);
    EXPECT_NEAR((arm + 0.1 * normal).dot(axis), 0, 1e-14);
  }
}

// A ball is a surface, too: on its surface, a point is pushed as by a sphere.
TEST(contact, of_a_point_and_a_curved_surface) {
  const auto model_with = [](bool is_surface) {
    two_bodies b;
    contact_data data = rough(b);
    if (is_surface)
      b.point_on_surface(
          b.center, b.place, b.plate,
          [](expression x, expression y, expression z) { return x * x + y * y + z * z - 0.09; }, data);
    else
      b.sphere_on_sphere(b.center, b.body, 0.0, b.place, b.plate, 0.3, data);
    return derive(b);
  };
  model surface = model_with(true), sphere = model_with(false);
  ASSERT_EQ(surface.mistake(), "");
  auto first = surface.function(surface.rhs()), second = sphere.function(sphere.rhs());
  std::mt19937 random(9);
  for (int i = 0; i < 20; ++i) {
    VectorXd x = state_near_contact(shape::point, random);
    const Eigen::Vector3d place(x[7], x[8], x[6]);
    Eigen::Vector3d line = x.head(3) - place;
    if (line.z() < 0) line.z() -= 0.1;
    x.head(3) = place + 0.3 * line.normalized();
    EXPECT_LT((first(x) - second(x)).norm(), 1e-11 * (1 + second(x).norm()));
  }
}

TEST(contact, mistakes_in_a_builder) {
  const auto mistake = [](const auto& change) {
    ball b(9.81);
    contact_data data = lossless();
    mechanics::vector up = b.up();
    change(b, data, up);
    b.sphere_on_plane(b.center, b.spin, 0.1, b.ground, up, data);
    return derive(b).mistake();
  };
  EXPECT_EQ(mistake([](ball&, contact_data& d, auto&) { d.exponent = 0.5; }),
            "the exponent of a contact is not a number from 1 to 30");
  EXPECT_EQ(mistake([](ball&, contact_data& d, auto&) { d.restitution = {1.2, 1}; }),
            "a coefficient of restitution is not in (0, 1]");
  EXPECT_EQ(mistake([](ball&, contact_data& d, auto&) { d.damping = 1, d.restitution = {0.2, 1}; }),
            "a contact has both a restitution and a damping");
  EXPECT_EQ(
      mistake([](ball& b, contact_data& d, auto&) { d.friction = friction_law::coulomb(b.number(1), {}); }),
      "the friction of a contact has no slip speed");
  EXPECT_EQ(mistake([](ball&, contact_data& d, auto&) { d.width = -1; }),
            "the width of the contact between C and O is not positive");
  EXPECT_EQ(mistake([](ball& b, contact_data& d, auto&) { d.width = b.mechanism().coordinates[0]; }),
            "the width of the contact between C and O contains the coordinate x; it may contain only "
            "parameters, inputs and time");
  EXPECT_EQ(mistake([](ball& b, contact_data&, auto& up) { up = b.along(b.spin, 1, 0, 0) + up; }),
            "a direction of a contact is given in the axes of two frames; write it in the axes of one");
  EXPECT_EQ(mistake([](ball& b, contact_data&, auto& up) { up = b.along(b.spin, 1, 0, 0); }),
            "a contact between C and O is between a body and itself");
  EXPECT_EQ(mistake([](ball& b, contact_data&, auto& up) {
              up = b.along(b.n, b.mechanism().coordinates[0], 0, 1);
            }),
            "the normal of the contact between C and O is not fixed in N; its components may contain only "
            "numbers and parameters");
  EXPECT_EQ(mistake([](ball&, contact_data& d, auto&) { d.restitution = {0.5, 0.0}; }),
            "the approach speed of a contact is not positive");
  EXPECT_EQ(mistake([](ball& b, contact_data& d, auto&) { d.rolling.lever = b.number(0.1); }),
            "the rolling resistance of a contact needs a lever and an angular velocity");
  EXPECT_EQ(
      mistake([](ball& b, contact_data& d, auto&) { d.friction = friction_law::coulomb({}, b.number(1)); }),
      "the friction of a contact has no coefficient");
  EXPECT_EQ(mistake([](ball& b, contact_data& d, auto&) {
              const builder other("M");
              b.torus_on_plane(b.center, b.spin, b.along(b.spin, 0, 1, 0), other.mechanism().time, 0.1,
                               b.ground, b.up(), d);
            }),
            "a contact contains an expression that belongs to a different mechanism or to none");
  EXPECT_EQ(mistake([](ball& b, contact_data& d, auto&) {
              d.friction = friction_law::dahl(b.number(1), {}, b.number(0.1), {});
            }),
            "the friction of a contact has no coefficient");
  EXPECT_EQ(mistake([](ball&, contact_data& d, auto&) { d.width = 1 / 2; }),
            "the width of a contact is 0, which is also the value of 1/2 in C++; write 0.5, or 0.0 if you "
            "mean zero");
}

} // namespace
