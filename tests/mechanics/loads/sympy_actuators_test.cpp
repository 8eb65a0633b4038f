// builds: clang++ all
// Actuators along pathways, the curves of muscles, activation dynamics and muscles with tendons at random
// states, compared with those of SymPy 1.14 (oracles/sympy_actuators.py).
#include "oracles.hpp"

#include <Eigen/Core>
#include <gtest/gtest.h>
#include <kanexpr/mechanics/motion/known_motion.hpp>
#include <kanexpr/numeric/muscle_curves.hpp>
#include <kanexpr/runtime/builder.hpp>

#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace {

namespace curves = kanexpr::numeric::muscle_curves;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using kanexpr::muscle_formulation;
using kanexpr::wrapping;
using kanexpr::mechanics::friction_law;
using kanexpr::mechanics::quantity;
using kanexpr::runtime::builder;
using kanexpr::runtime::frame_id;
using kanexpr::runtime::muscle_data;
using kanexpr::runtime::muscle_states;
using kanexpr::runtime::pathway;
using kanexpr::runtime::point_id;
using kanexpr::runtime::pulling_load;
using kanexpr::symbolic::expression;
using kanexpr::symbolic::matrix;

const std::map<std::string, MatrixXd>& tables() {
  static const std::map<std::string, MatrixXd> all = oracle::load_tables("sympy_actuators");
  return all;
}

void expect_near(double actual, double expected, double scale) {
  EXPECT_NEAR(actual, expected, 1e-12 * scale);
}

TEST(sympy, curves) {
  const MatrixXd& all = tables().at("curves");
  ASSERT_EQ(all.cols(), 14);
  for (Eigen::Index i = 0; i < all.rows(); ++i) {
    const VectorXd row = all.row(i);
    const double found[]{curves::tendon_force(row(0), 0.049), curves::tendon_length(row(2), 0.049),
                         curves::passive_force(row(4), 0.6),  curves::passive_length(row(6), 0.6),
                         curves::active_force(row(8)),        curves::velocity_force(row(10)),
                         curves::velocity_with_force(row(12))};
    for (int k = 0; k < 7; ++k) expect_near(found[k], row(2 * k + 1), 1 + std::abs(row(2 * k + 1)));
  }
}

TEST(sympy, activation) {
  builder b("N");
  const expression q = b.coordinate("q"), u = b.speed("u"), e = b.input("e"), rise = b.parameter("Ta"),
                   fall = b.parameter("Td");
  b.kinematic_equation(b.dot(q) - u);
  const point_id p = b.offset("P", b.origin("O"), b.along(b.inertial_frame(), q, 0, 0));
  b.particle("Bob", p, b.number(1));
  b.muscle_activation("m", e, rise, fall);
  auto model = kanexpr::derive(b);
  ASSERT_EQ(model.mistake(), "");
  auto rates = model.function(model.get(quantity::rhs));
  const MatrixXd& all = tables().at("activation");
  for (Eigen::Index i = 0; i < all.rows(); ++i) {
    const VectorXd row = all.row(i);
    const VectorXd found = rates(Eigen::Vector3d(0, 0, row(1)), Eigen::Vector2d(row(2), row(3)), row.head(1));
    expect_near(found(2), row(4), std::abs(row(4)));
  }
}

// A particle with the mass 1 at the distance q from the origin of a muscle; the rate of the distance is u.
struct pulled : builder {
  muscle_states states{};

  pulled(muscle_formulation formulation, bool is_pennate, bool is_damped) : builder("N") {
    const expression q = coordinate("q"), u = speed("u"), a = input("a");
    kinematic_equation(dot(q) - u);
    const point_id o = origin("O"), p = offset("P", o, along(inertial_frame(), q, 0, 0));
    particle("Bob", p, number(1));
    std::vector<expression> s;
    for (const char* name : {"F", "fiber", "slack", "velocity", "angle", "damping"})
      s.push_back(parameter(name));
    for (const expression& each : s) used_elsewhere(each);
    states = muscle("m", straight(o, p), a,
                    {.peak_isometric_force = s[0],
                     .optimal_fiber_length = s[1],
                     .tendon_slack_length = s[2],
                     .maximal_fiber_velocity = s[3] / s[1],
                     .pennation = is_pennate ? s[4] : number(0.0),
                     .fiber_damping = is_damped ? s[5] : number(0.0),
                     .has_activation_dynamics = false,
                     .formulation = formulation});
  }
};

void expect_muscle(const std::string& table, muscle_formulation formulation, bool is_pennate) {
  SCOPED_TRACE(table);
  const bool is_rigid = formulation == muscle_formulation::rigid_tendon;
  pulled b(formulation, is_pennate, is_rigid);
  auto model = kanexpr::derive(b);
  ASSERT_EQ(model.mistake(), "");
  auto rates = model.function(model.get(quantity::rhs));
  const MatrixXd& all = tables().at(table);
  ASSERT_EQ(all.rows(), 20);
  for (Eigen::Index i = 0; i < all.rows(); ++i) {
    const VectorXd row = all.row(i);
    const double length = row(6), rate = row(7);
    VectorXd x(is_rigid ? 2 : 3);
    x(0) = length, x(1) = rate;
    if (!is_rigid) x(2) = row(9);
    const VectorXd found = rates(x, row.head(6), row.segment(8, 1));
    double force = row(10), velocity = rate;
    if (is_rigid && is_pennate) {
      // SymPy 1.14 projects the force of fibers at a rigid tendon with the pennation at the optimal length
      const double projected = length - row(2), width = row(1) * std::sin(row(4));
      force *= projected / std::hypot(projected, width) / std::cos(row(4));
    }
    expect_near(found(0), velocity, std::abs(velocity));
    expect_near(found(1), force, std::abs(force) + 1e-1 * row(0));
    if (!is_rigid) expect_near(found(2), row(11), std::abs(row(11)) + 1);
  }
}

TEST(sympy, musculotendons) {
  using enum muscle_formulation;
  expect_muscle("rigid tendon", rigid_tendon, false);
  expect_muscle("rigid tendon, pennate", rigid_tendon, true);
  expect_muscle("tendon force", tendon_force, false);
  expect_muscle("tendon force, pennate", tendon_force, true);
  expect_muscle("fiber length", fiber_length, false);
  expect_muscle("fiber length, pennate", fiber_length, true);
}

// The two bodies of the script.
struct two_bodies : builder {
  frame_id n = inertial_frame(), a, b;
  std::map<std::string, expression> given;

  two_bodies() : builder("N") {
    const expression q1 = coordinate("q1"), q2 = coordinate("q2"), u1 = speed("u1"), u2 = speed("u2");
    kinematic_equation(dot(q1) - u1);
    kinematic_equation(dot(q2) - u2);
    a = rotated("A", n, q1, along(n, 0, 0, 1));
    b = rotated("B", a, q2, along(a, 1, 0, 0));
    for (const char* name : {"k", "k3", "c", "rest", "F", "mu", "normal", "sigma"})
      used_elsewhere(given[name] = parameter(name));
  }

  pathway path(const std::string& called) {
    const expression q2 = mechanism().coordinates[1];
    const point_id o = origin("O"), p = offset("P", o, along(a, 0, 1, 0.2)),
                   q = offset("Q", p, along(b, q2, 0.8, -0.5)), w = offset("W", o, along(n, 1.5, 0, -0.25)),
                   e = offset("E", o, along(a, 0.3, 0, 0.1)), s = offset("S", o, along(n, 0.3, 0, 0)),
                   r = offset("R", o, along(a, 0.3, 0, 0) + along(n, 0, 0, 0.4 + q2)),
                   t = offset("T", o, along(b, 0, 0.3, 0));
    particle("Bob", q, number(1));
    if (called == "straight") return straight(q, w);
    if (called == "through") return through({q, p, e, w});
    if (called == "around a sphere") return around_sphere(o, number(0.3), on_surface(s), on_surface(t));
    return around_cylinder(n, o, along(n, 0, 0, 1), number(0.3), on_surface(s), on_surface(r),
                           wrapping::counterclockwise);
  }

  pulling_load act(int actuator, const pathway& along) {
    const auto& g = given;
    switch (actuator) {
    case 0: return linear_spring(along, g.at("k"), g.at("rest"));
    case 1: return cubic_spring(along, g.at("k"), g.at("k3"), g.at("rest"));
    case 2: return linear_damper(along, g.at("c"));
    case 3: return force_along(along, -g.at("F")); // SymPy's positive forces lengthen a pathway
    default:
      friction_along(along, g.at("normal"), friction_law::coulomb(g.at("mu"), number(1e-10)));
      return linear_damper(along, g.at("sigma"));
    }
  }
};

TEST(sympy, actuators) {
  for (const std::string called : {"straight", "through", "around a cylinder", "around a sphere"})
    for (int actuator = 0; actuator < 5; ++actuator) {
      SCOPED_TRACE(called + " " + std::to_string(actuator));
      two_bodies b;
      const pathway path = b.path(called);
      b.act(actuator, path);
      matrix lengths(b.graph(), 2, 1);
      kanexpr::mechanics::known_motion known(b.mechanism());
      lengths.entries[0] = b.length_of(path);
      lengths.entries[1] = known.moving().rate(lengths.entries[0]);
      auto model = kanexpr::derive(b);
      ASSERT_EQ(model.mistake(), "");
      auto length = model.function(lengths), force = model.function(model.get(quantity::load_compensation));
      // along a WrappingPathway, SymPy 1.14 takes a positive force as a tension
      const double sign = called.starts_with("around") ? -1 : 1;
      const MatrixXd& all = tables().at(called);
      ASSERT_EQ(all.rows(), 10);
      for (Eigen::Index i = 0; i < all.rows(); ++i) {
        const VectorXd row = all.row(i);
        const VectorXd l = length(row.head(4), row.segment(4, 8)),
                       f = -VectorXd(force(row.head(4), row.segment(4, 8))),
                       expected = sign * row.segment(14 + 2 * actuator, 2);
        expect_near(l(0), row(12), row(12));
        expect_near(l(1), row(13), 1 + std::abs(row(13)));
        EXPECT_LT((f - expected).norm(), 1e-12 * (1 + expected.norm()));
      }
    }
}

TEST(sympy, torque_actuator) {
  two_bodies b;
  const point_id o = b.origin("O"), p = b.offset("P", o, b.along(b.b, 0, 1, 0.5));
  b.particle("Bob", p, b.number(1));
  b.torque_between(b.b, b.n, b.along(b.b, 0, b.given.at("F"), 0));
  auto model = kanexpr::derive(b);
  ASSERT_EQ(model.mistake(), "");
  auto force = model.function(model.get(quantity::load_compensation));
  const MatrixXd& all = tables().at("torque");
  for (Eigen::Index i = 0; i < all.rows(); ++i) {
    const VectorXd row = all.row(i);
    const VectorXd parameters = row(4) * VectorXd::Unit(8, 4), f = -VectorXd(force(row.head(4), parameters));
    EXPECT_LT((f - row.segment(5, 2)).norm(), 1e-12);
  }
}

} // namespace
