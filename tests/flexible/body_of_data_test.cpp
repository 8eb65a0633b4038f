// builds: clang++ all
// Bodies from files at run time, compared with models of their particles.
#include "flexible/beam_of_particles.hpp"
#include "flexible/modes_file.hpp"
#include "flexible/vehicle.hpp"

#include <kanexpr/flexible/read_modes.hpp>
#include <kanexpr/flexible/read_sid.hpp>
#include <kanexpr/mechanics/equations.hpp>
#include <kanexpr/numeric/beams/shape.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/runtime/model.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace vehicles;
using lumped::beam_of_particles;

lumped::body undamped(bool bends) {
  lumped::body b = lumped::random_body(amplitudes, 6, bends, 21);
  b.damping.setZero();
  return b;
}

TEST(body_of_data, equals_its_particles) {
  const lumped::body b = undamped(false);
  vehicle found(b, kind::of_data), expected(b, kind::of_particles);
  ASSERT_EQ(found.check().view(), "");
  ASSERT_EQ(expected.check().view(), "");
  mechanics::equations by_data(found.system()), by_particles(expected.system());
  for (const unsigned seed : {1u, 2u, 3u}) {
    found.draw(seed), expected.draw(seed);
    for (const quantity each :
         {quantity::mass_matrix, quantity::forcing, quantity::inverse_dynamics, quantity::kinetic_energy,
          quantity::potential_energy, quantity::linear_momentum, quantity::angular_momentum})
      expect_equal(found.numbers(by_data.get(each)), expected.numbers(by_particles.get(each)),
                   std::string(mechanics::row_of(each).called));
  }
}

/// Particles that bend to the second order: equal linear equations about any motion without deformation.
TEST(body_of_data, stiffens_like_its_particles) {
  const lumped::body b = undamped(true);
  vehicle found(b, kind::of_data), expected(b, kind::of_particles);
  const kanexpr::symbolic::matrix by_data = derivatives(found), by_particles = derivatives(expected);
  for (const unsigned seed : {1u, 2u, 3u}) {
    found.draw_undeformed(seed), expected.draw_undeformed(seed);
    expect_equal(found.numbers(by_data), expected.numbers(by_particles), "derivatives");
  }
}

/// Nodes with rotary inertia: equal to rigid bodies on massless modes to the second order.
TEST(body_of_data, has_the_rotary_inertia_of_its_nodes) {
  const lumped::body b = lumped::random_body_of_rigid_bodies(amplitudes, 4, 33);
  nlohmann::json file = lumped::file_of(b);
  file.erase("damping");
  const auto read = kanexpr::flexible::read_modes_text(file.dump());
  ASSERT_TRUE(read) << read.cause();
  mechanics::flexible_data data = read.data;
  data.nodes[0].called = kanexpr::base::name("12");
  vehicle found(data), expected(b, kind::of_particles);
  ASSERT_EQ(found.check().view(), "");
  ASSERT_EQ(expected.check().view(), "");
  mechanics::equations of_nodes(found.system()), of_bodies(expected.system());
  const kanexpr::symbolic::matrix by_data = derivatives(found), by_bodies = derivatives(expected);
  for (const unsigned seed : {1u, 2u, 3u}) {
    found.draw_undeformed(seed), expected.draw_undeformed(seed);
    expect_equal(found.numbers(of_nodes.get(quantity::mass_matrix)),
                 expected.numbers(of_bodies.get(quantity::mass_matrix)), "mass matrix");
    expect_equal(found.numbers(by_data), expected.numbers(by_bodies), "derivatives");
  }
}

TEST(body_of_data, damps_its_amplitudes) {
  lumped::body b = undamped(false);
  vehicle without(b, kind::of_data);
  b.damping << 2, 0.5, 0.5, 3;
  vehicle with(b, kind::of_data);
  without.draw(4), with.draw(4);
  mechanics::equations damped(with.system()), undamped_equations(without.system());
  const VectorXd difference = with.numbers(damped.get(quantity::forcing)) -
                              without.numbers(undamped_equations.get(quantity::forcing));
  VectorXd expected = VectorXd::Zero(all);
  expected.tail(amplitudes) = -b.damping * with.u_now.tail(amplitudes);
  expect_equal(difference, expected, "damping");
}

/// The forces of an energy of fourth order, and of a damping that depends on the amplitudes.
TEST(body_of_data, has_the_elastic_forces_of_its_energy) {
  lumped::body b = undamped(true);
  vehicle linear(b, kind::of_data);
  b.preload = lumped::random_tensor(amplitudes, 1, 1);
  b.third = lumped::random_tensor(amplitudes, 3, 2);
  b.fourth = lumped::random_tensor(amplitudes, 4, 3);
  b.damping_rate = lumped::random_tensor(amplitudes, 3, 4);
  b.second_damping_rate = lumped::random_tensor(amplitudes, 4, 5);
  vehicle full(b, kind::of_data);
  linear.draw(6), full.draw(6);
  mechanics::equations by_terms(full.system()), without(linear.system());
  const VectorXd q = full.q_now.tail(amplitudes), u = full.u_now.tail(amplitudes);
  VectorXd expected = VectorXd::Zero(all);
  for (int k = 0; k < amplitudes; ++k) {
    double force = b.entry(b.preload, k);
    for (int l = 0; l < amplitudes; ++l)
      for (int m = 0; m < amplitudes; ++m) {
        force += b.entry(b.third, k, l, m) / 2 * q[l] * q[m] + b.entry(b.damping_rate, k, l, m) * q[m] * u[l];
        for (int n = 0; n < amplitudes; ++n)
          force += b.entry(b.fourth, k, l, m, n) / 6 * q[l] * q[m] * q[n] +
                   b.entry(b.second_damping_rate, k, l, m, n) / 2 * q[m] * q[n] * u[l];
      }
    expected[rigid + k] = -force;
  }
  expect_equal(full.numbers(by_terms.get(quantity::forcing)) - linear.numbers(without.get(quantity::forcing)),
               expected, "elastic forces");
}

/// A beam that bends in two directions, with a rigid body on a hinge at its tip. The rotation of the tip to
/// the second order in the amplitudes, the linear part of psi, affects the linear equations.
struct skew_cantilever : vehicle_base {
  skew_cantilever(const beam_of_particles& of, bool from_file) {
    const kanexpr::runtime::section_ids end =
        from_file
            ? node("Tip",
                   flexible_body("Panel", at, axes, {amplitude(0), amplitude(1)},
                                 data_of(of.with_stiffness(8))),
                   "12")
            : section("Tip",
                      beam("Panel", at, axes, {amplitude(0), amplitude(1)}, beam_data_of(*this, of, axes, 8)),
                      1);
    const frame_id load = rotated("L", end.frame, q[6], along(end.frame, 0.6, 0, 0.8));
    rigid_body("Load", offset("C", end.point, along(load, 0.3, 0.1, -0.2)), load, number(0.8),
               inertia(load, 0.3, 0.4, 0.5, 0.02, 0, 0));
    gravity(along(inertial_frame(), 0.3, -9.81, 1));
    torque(end.frame, along(axes, 0.4, -0.3, 2));
  }
};

TEST(body_of_data, turns_its_nodes_like_the_sections_of_a_beam) {
  const beam_of_particles of{.first = {2}, .second = {3}};
  skew_cantilever found(of, true), expected(of, false);
  ASSERT_EQ(found.check().view(), "");
  ASSERT_EQ(expected.check().view(), "");
  const kanexpr::symbolic::matrix by_data = derivatives(found), by_shapes = derivatives(expected);
  for (const unsigned seed : {1u, 2u, 3u}) {
    found.draw_undeformed(seed), expected.draw_undeformed(seed);
    expect_equal(found.numbers(by_data), expected.numbers(by_shapes), "derivatives");
  }
}

/// A beam on a hub that spins up from rest to the rate 6 rad/s in 15 s (Kane, Ryan & Banerjee 1987).
struct spinning : builder {
  explicit spinning(bool from_file) : builder("N") {
    const beam_of_particles of{.length = 10, .mass_per_length = 1.2, .first = {2, 3}};
    const double stiffness = 1.4e4, turn = 2 * 3.141592653589793 / 15;
    const expression t = time(), angle = 6.0 / 15 * (t * t / 2 + (cos(turn * t) - 1) / (turn * turn));
    const frame_id n = inertial_frame(), hub = rotated("H", n, angle, along(n, 0, 0, 1));
    std::vector<expression> q;
    for (const char* k : {"1", "2"}) {
      q.push_back(coordinate(std::string("q") + k));
      kinematic_equation(dot(q.back()) - speed(std::string("u") + k));
    }
    if (from_file)
      flexible_body("Beam", origin("O"), hub, q, data_of(of.with_stiffness(stiffness)));
    else
      beam("Beam", origin("O"), hub, q, beam_data_of(*this, of, hub, stiffness));
  }
};

/// The base is not moved by speeds, so the beam has no terms of higher order: the equations agree at all
/// amplitudes, and so does the motion.
TEST(body_of_data, equals_a_beam_that_spins_up) {
  kanexpr::model found = kanexpr::derive(spinning(true)), expected = kanexpr::derive(spinning(false));
  ASSERT_EQ(found.mistake(), "");
  ASSERT_EQ(expected.mistake(), "");
  auto by_data = found.function(found.rhs()), by_shapes = expected.function(expected.rhs());
  VectorXd x = VectorXd::Zero(4), y = x;
  const auto step = [](auto& rate, VectorXd& at, double t, double h) {
    const auto f = [&](double time, const VectorXd& state) {
      return VectorXd(rate(time, state, VectorXd(), VectorXd()));
    };
    const VectorXd a = f(t, at), b = f(t + h / 2, at + h / 2 * a), c = f(t + h / 2, at + h / 2 * b),
                   d = f(t + h, at + h * c);
    at += h / 6 * (a + 2 * b + 2 * c + d);
  };
  const double h = 0.004;
  double lag = 0;
  for (int i = 0; i < 4000; ++i) {
    const double t = i * h;
    const VectorXd one = by_data(t, x, VectorXd(), VectorXd()),
                   other = by_shapes(t, x, VectorXd(), VectorXd());
    ASSERT_LE((one - other).cwiseAbs().maxCoeff(), 1e-12 * (1 + other.cwiseAbs().maxCoeff())) << t;
    step(by_data, x, t, h), step(by_shapes, y, t, h);
    lag = (std::min)(lag, 100 * y[0] + 1000 * y[1]);
  }
  EXPECT_LE((x - y).cwiseAbs().maxCoeff(), 1e-11);
  EXPECT_NEAR(lag, -0.57, 0.02); // the tip lags by half a meter, and returns
  EXPECT_NEAR(100 * y[0] + 1000 * y[1], 0, 0.03);
}

/// A uniform cantilever with a particle at its tip, on a base that moves freely.
struct cantilever : vehicle_base {
  explicit cantilever(bool from_file) {
    const point_id end =
        from_file ? node("Tip", add_body(), "tip").point : section("Tip", add_beam(), 1).point;
    particle("Bob", end, number(0.4));
    gravity(along(inertial_frame(), 0.3, -9.81, 1));
  }

private:
  kanexpr::runtime::flexible_body_id add_body() {
    const auto read =
        kanexpr::flexible::read_sid(std::string(KANEXPR_FLEXIBLE_FILES) + "/cantilever.SID_FEM");
    EXPECT_TRUE(read) << read.cause();
    return flexible_body("Panel", at, axes, {amplitude(0), amplitude(1)}, read.data);
  }
  kanexpr::runtime::beam_id add_beam() {
    using kanexpr::numeric::beams::shape;
    return beam("Panel", at, axes, {amplitude(0), amplitude(1)},
                {.axis = along(axes, 1, 0, 0),
                 .length = 1.0,
                 .mass_per_length = 1.5,
                 .bending = {{along(axes, 0, 1, 0),
                              {.stiffness = 8.0,
                               .shapes = {shape::polynomial({0.0, 0.0, 1.0}),
                                          shape::polynomial({0.0, 0.0, 0.0, 1.0})}}}},
                 .damping_of_stiffness = 0.02});
  }
};

/// The kinetic energy of a beam whose base moves contains terms of higher order, so that it is positive. Up
/// to the second order, it is that of the file: the linear equations about any motion without deformation
/// agree.
TEST(body_of_data, equals_a_beam) {
  cantilever found(true), expected(false);
  ASSERT_EQ(found.check().view(), "");
  ASSERT_EQ(expected.check().view(), "");
  mechanics::equations by_data(found.system()), by_shapes(expected.system());
  const kanexpr::symbolic::matrix linear_by_data = derivatives(found),
                                  linear_by_shapes = derivatives(expected);
  for (const unsigned seed : {1u, 2u, 3u}) {
    found.draw_undeformed(seed), expected.draw_undeformed(seed);
    for (const quantity each :
         {quantity::mass_matrix, quantity::forcing, quantity::kinetic_energy, quantity::potential_energy})
      expect_equal(found.numbers(by_data.get(each)), expected.numbers(by_shapes.get(each)),
                   std::string(mechanics::row_of(each).called));
    expect_equal(found.numbers(linear_by_data), expected.numbers(linear_by_shapes), "derivatives");
  }
}

TEST(body_of_data, is_loaded_by_reference_stresses) {
  const lumped::body b = undamped(false);
  mechanics::flexible_data data = data_of(b);
  vehicle without(data);
  data.preload = {2.0, -3.0};
  vehicle with(data);
  without.draw(4), with.draw(4);
  mechanics::equations loaded(with.system()), unloaded(without.system());
  VectorXd expected = VectorXd::Zero(all);
  expected.tail(amplitudes) << -2, 3;
  expect_equal(with.numbers(loaded.get(quantity::forcing)) - without.numbers(unloaded.get(quantity::forcing)),
               expected, "preload");
}

TEST(body_of_data, reports_incomplete_numbers) {
  const auto mistake_after = [](const auto& change) {
    mechanics::flexible_data data = data_of(undamped(false));
    change(data);
    builder b("N");
    const expression first = b.coordinate("q1"), second = b.coordinate("q2");
    b.flexible_body("Panel", b.origin("O"), b.inertial_frame(), {first, second}, data);
    return std::string(b.mistake().view());
  };
  const auto no_change = [](const mechanics::flexible_data&) {};
  EXPECT_EQ(mistake_after(no_change), "");
  const std::string incomplete =
      "the numbers of Panel are incomplete: a list has a length that does not fit the number of amplitudes, "
      "or a term the index of no amplitude";
  const std::string incomplete_node =
      "node 12 of Panel is incomplete: a list has a length that does not fit the number of amplitudes";
  EXPECT_EQ(mistake_after([](auto& d) { d.first_moment.coefficients = {1.0, 2.0}; }), incomplete);
  EXPECT_EQ(mistake_after([](auto& d) { d.stiffness = {}; }), incomplete);
  EXPECT_EQ(mistake_after([](auto& d) { d.stiffness[3] = std::numeric_limits<double>::quiet_NaN(); }),
            "Panel contains a number that is not finite");
  EXPECT_EQ(mistake_after([](auto& d) { d.elastic_terms.push({1.0, {0, 1, 2, -1}}); }), incomplete);
  EXPECT_EQ(mistake_after([](auto& d) { d.elastic_terms.push({1.0, {0, 1, 1, -1}}); }), "");
  EXPECT_EQ(mistake_after([](auto& d) { d.damping_terms.push({1.0, 0, 2, {0, -1}}); }), incomplete);
  EXPECT_EQ(mistake_after([](auto& d) { d.nodes[0].position = mechanics::taylor_series(2, 2); }),
            incomplete_node);
  EXPECT_EQ(mistake_after([](auto& d) { d.nodes[0].rotation = {1.0, 0.0}; }), incomplete_node);
  EXPECT_EQ(mistake_after([](auto& d) { d.nodes[0].second_rotation = {1.0}; }), incomplete_node);
  EXPECT_EQ(mistake_after([](auto& d) { d.nodes[0].orientation = {1.0}; }), incomplete_node);
  EXPECT_EQ(mistake_after([](auto& d) { d.nodes[0].orientation = {}, d.nodes[0].rotation = {}; }), "");
  EXPECT_EQ(mistake_after([](auto& d) { d.stiffness[3] = -1; }),
            "the stiffness of q2, an amplitude of Panel, is negative");
  EXPECT_EQ(mistake_after([](auto& d) { d.damping[0] = -1; }),
            "the damping of q1, an amplitude of Panel, is negative");
  EXPECT_EQ(mistake_after([](auto& d) { d.amplitudes = -1; }),
            "flexible body Panel has -1 amplitudes; expected at least 1");
}

TEST(body_of_data, reports_mistakes) {
  const mechanics::flexible_data data = data_of(undamped(false));
  builder b("N");
  const point_id o = b.origin("O");
  const expression q = b.coordinate("q"), u = b.speed("u");
  b.kinematic_equation(b.dot(q) - u);
  b.flexible_body("Panel", o, b.inertial_frame(), {q}, data);
  EXPECT_EQ(b.mistake().view(), "expected 2 amplitudes of Panel, got 1");
  builder c("N");
  const expression first = c.coordinate("q1"), second = c.coordinate("q2");
  const auto panel = c.flexible_body("Panel", c.origin("O"), c.inertial_frame(), {first, second}, data);
  c.node("Tip", panel, "13");
  EXPECT_EQ(c.mistake().view(), "flexible body Panel has no node 13");
  builder d("N");
  d.node("Tip", panel, "12");
  EXPECT_EQ(d.mistake().view(), "node Tip belongs to a flexible body of a different builder, or to none");
}

} // namespace
