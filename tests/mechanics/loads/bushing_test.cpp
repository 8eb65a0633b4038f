// builds: clang++ all
// Bushings: closed forms, Kane's method compared with Lagrange's, and momentum.
#include <Eigen/Core>
#include <Eigen/Dense>
#include <gtest/gtest.h>
#include <kanexpr/runtime/builder.hpp>

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace {

namespace mechanics = kanexpr::mechanics;
using Eigen::VectorXd;
using kanexpr::runtime::builder;
using kanexpr::runtime::frame_id;
using kanexpr::runtime::point_id;
using kanexpr::symbolic::expression;
using mechanics::quantity;

const std::vector<double> stiffnesses{40, 50, 60, 3, 4, 5}, dampings{0.4, 0.5, 0.6, 0.03, 0.04, 0.05};

std::vector<expression> as_expressions(builder& b, const std::vector<double>& numbers) {
  std::vector<expression> all;
  for (const double each : numbers) all.push_back(b.number(each));
  return all;
}

// Two free bodies in space, mounted on each other.
struct pair_of_bodies : builder {
  std::vector<expression> q;

  explicit pair_of_bodies(bool is_damped) : builder("N") {
    for (int i = 0; i < 12; ++i) q.push_back(coordinate("q" + std::to_string(i)));
    rates_as_speeds();
    const frame_id n = inertial_frame();
    const point_id o = origin("O");
    const frame_id a = body_fixed("A", n, "xyz", q[3], q[4], q[5]),
                   c = body_fixed("C", n, "xyz", q[9], q[10], q[11]);
    const point_id first = offset("F", o, along(n, q[0], q[1], q[2])),
                   second = offset("S", o, along(n, q[6], q[7], q[8]));
    rigid_body("first", first, a, number(1.3), inertia(a, 0.2, 0.3, 0.4));
    rigid_body("second", second, c, number(0.7), inertia(c, 0.1, 0.2, 0.25));
    bushing(c, offset("P", second, along(c, 0.1, 0.2, -0.1)), a, offset("Q", first, along(a, -0.2, 0.1, 0.3)),
            as_expressions(*this, stiffnesses),
            is_damped ? as_expressions(*this, dampings) : std::vector<expression>{});
  }
};

VectorXd random_state(std::mt19937_64& source) {
  std::uniform_real_distribution<double> value(-0.9, 0.9);
  VectorXd x(24);
  for (double& each : x) each = value(source);
  return x;
}

// The rate of the energy is the power of the damping, which only takes; without damping it vanishes. The
// forces are internal, so the momenta stay.
TEST(bushing, conserves_momenta_and_takes_energy) {
  for (const bool is_damped : {false, true}) {
    pair_of_bodies b(is_damped);
    auto model = kanexpr::derive(b);
    ASSERT_EQ(model.mistake(), "");
    auto rhs = model.function(model.get(quantity::rhs)),
         energies = model.function(model.get(quantity::kinetic_energy)),
         potential = model.function(model.get(quantity::potential_energy)),
         linear = model.function(model.get(quantity::linear_momentum)),
         angular = model.function(model.get(quantity::angular_momentum));
    std::mt19937_64 source(2);
    for (int i = 0; i < 50; ++i) {
      const VectorXd x = random_state(source), rate = rhs(x);
      const auto derivative = [&](auto& f) {
        const double h = 1e-4 / (1 + rate.norm());
        const VectorXd after = f(VectorXd(x + h * rate)), before = f(VectorXd(x - h * rate)),
                       farther = f(VectorXd(x + 2 * h * rate)), back = f(VectorXd(x - 2 * h * rate));
        return VectorXd((8 * (after - before) - (farther - back)) / (12 * h));
      };
      const double power = derivative(energies)(0) + derivative(potential)(0);
      const double scale = 1e-8 * (1 + rate.norm()) * (1 + x.norm());
      if (is_damped)
        EXPECT_LT(power, 0);
      else
        EXPECT_NEAR(power, 0, scale);
      EXPECT_LT(derivative(linear).norm(), scale);
      EXPECT_LT(derivative(angular).norm(), scale);
    }
  }
}

// One body on the ground by Kane's method, which applies forces, and by Lagrange's.
TEST(bushing, agrees_with_lagrange) {
  const auto mounted = [](builder& b, bool by_lagrange) {
    std::vector<expression> q, u;
    for (int i = 0; i < 6; ++i) q.push_back(b.coordinate("q" + std::to_string(i)));
    if (by_lagrange) b.rates_as_speeds();
    for (int i = 0; i < 6 && !by_lagrange; ++i) {
      u.push_back(b.speed("u" + std::to_string(i)));
      b.kinematic_equation(b.dot(q[static_cast<std::size_t>(i)]) - u.back());
    }
    const frame_id n = b.inertial_frame();
    const point_id o = b.origin("O"), p = b.offset("P", o, b.along(n, q[0], q[1], q[2]));
    const frame_id a = b.body_fixed("A", n, "zyx", q[3], q[4], q[5]);
    b.rigid_body("body", p, a, b.number(1.3), b.inertia(a, 0.2, 0.3, 0.4));
    b.bushing(n, o, a, b.offset("Q", p, b.along(a, 0.3, 0.1, 0.2)), as_expressions(b, stiffnesses),
              as_expressions(b, dampings));
    return kanexpr::derive(b);
  };
  builder first("N"), second("N");
  auto kane = mounted(first, false), lagrange = mounted(second, true);
  ASSERT_EQ(kane.mistake(), "");
  ASSERT_EQ(lagrange.mistake(), "");
  auto one = kane.function(kane.get(quantity::udot)), other = lagrange.function(lagrange.get(quantity::udot));
  std::mt19937_64 source(8);
  for (int i = 0; i < 50; ++i) {
    const VectorXd x = random_state(source).head(12), a = one(x), b = other(x);
    EXPECT_LT((a - b).norm(), 1e-11 * (1 + b.norm()));
  }
}

// About one axis, the torque is k sin θ; along one, the force is k d.
TEST(bushing, follows_closed_forms) {
  builder b("N");
  const expression q = b.coordinate("q"), z = b.coordinate("z");
  b.rates_as_speeds();
  const frame_id n = b.inertial_frame(), a = b.rotated("A", n, q, b.along(n, 0, 0, 1));
  const point_id o = b.origin("O"), p = b.offset("P", o, b.along(n, 0, 0, z));
  b.rigid_body("body", p, a, b.number(2), b.inertia(a, 1, 1, 0.5));
  b.bushing(a, p, n, o, as_expressions(b, stiffnesses), as_expressions(b, dampings));
  auto model = kanexpr::derive(b);
  ASSERT_EQ(model.mistake(), "");
  auto udot = model.function(model.get(quantity::udot));
  const VectorXd found = udot(Eigen::Vector4d(0.7, 0.2, -0.3, 0.4));
  EXPECT_NEAR(found(0), (-5 * std::sin(0.7) + 0.05 * 0.3) / 0.5, 1e-12);
  EXPECT_NEAR(found(1), (-60 * 0.2 - 0.6 * 0.4) / 2, 1e-12);
}

TEST(bushing, reports_mistakes) {
  builder b("N");
  const frame_id n = b.inertial_frame();
  const point_id o = b.origin("O");
  b.bushing(n, o, n, o, {b.number(1), b.number(2)});
  EXPECT_EQ(b.mistake().view(),
            "expected six stiffnesses and six dampings or none of a bushing, got 2 and 0");
}

} // namespace
