// Bodies from files at run time, compared with models of their particles.
#include "flexible/lumped_body.hpp"

#include <kanexpr/flexible/read_sid.hpp>
#include <kanexpr/mechanics/equations.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/runtime/interpreter.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <string>
#include <vector>

namespace {

namespace mechanics = kanexpr::mechanics;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using kanexpr::runtime::builder;
using kanexpr::runtime::frame_id;
using kanexpr::runtime::point_id;
using kanexpr::symbolic::expression;
using lumped::Vector3d;
using mechanics::quantity;

constexpr int rigid = 7; // a free frame, and a rigid body on a hinge at the node
constexpr int amplitudes = 2;
constexpr int all = rigid + amplitudes;

mechanics::flexible_data data_of(const lumped::body& b) {
  const auto read = kanexpr::flexible::read_sid_text(lumped::sid_text(b, lumped::fembs));
  EXPECT_TRUE(read) << read.cause();
  return read.data;
}

enum class kind { of_data, of_particles };

/// A frame that moves freely, with coordinates for a hinge and for the amplitudes of a body.
struct vehicle_base : builder {
  std::vector<expression> q, u;
  VectorXd q_now, u_now, udot_now;
  frame_id axes{};
  point_id at{};

  vehicle_base() : builder("N") {
    for (int i = 0; i < all; ++i) {
      q.push_back(coordinate("q" + std::to_string(i)));
      u.push_back(speed("u" + std::to_string(i)));
      kinematic_equation(dot(q.back()) - u.back());
    }
    const frame_id n = inertial_frame();
    axes = body_fixed("B", n, "xyz", q[3], q[4], q[5]);
    at = offset("A", origin("O"), along(n, q[0], q[1], q[2]));
    const frame_id wheel = rotated("W", n, q[6], along(n, 1, 0, 0));
    rigid_body("Wheel", origin("O2"), wheel, number(0.1), inertia(wheel, 0.1, 0.2, 0.3));
  }
  static std::size_t index(int k) { return static_cast<std::size_t>(k); }
  const expression& amplitude(int k) const { return q[index(rigid + k)]; }

  void draw(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> between(-1, 1);
    for (VectorXd* v : {&q_now, &u_now, &udot_now})
      *v = VectorXd::NullaryExpr(all, [&] { return between(random); });
  }

  void draw_undeformed(unsigned seed) {
    draw(seed);
    for (VectorXd* v : {&q_now, &u_now, &udot_now}) v->tail(amplitudes).setZero();
  }

  MatrixXd numbers(const kanexpr::symbolic::matrix& wanted) {
    kanexpr::base::sequence<int> outputs;
    for (const expression& e : wanted.entries) outputs.push(e.node());
    kanexpr::runtime::interpreter<double> code(kanexpr::lower::tape_of(graph(), outputs));
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> result(wanted.rows,
                                                                                  wanted.columns);
    const auto value_of = [&](const kanexpr::lower::load& l) {
      using kanexpr::symbolic::symbol_kind;
      if (l.from == symbol_kind::coordinate) return q_now[l.position];
      if (l.from == symbol_kind::speed) return u_now[l.position];
      if (l.from == symbol_kind::speed_rate) return udot_now[l.position];
      return std::numeric_limits<double>::quiet_NaN();
    };
    code.evaluate(value_of, result.data());
    return result;
  }
};

/// A free body that carries a rigid body on a hinge at its node.
struct vehicle : vehicle_base {
  explicit vehicle(const mechanics::flexible_data& data) {
    carry(node("Node", flexible_body("Panel", at, axes, {amplitude(0), amplitude(1)}, data), "12"));
  }
  vehicle(const lumped::body& b, kind how) {
    if (how == kind::of_particles)
      carry(add_particles(b));
    else
      carry(node("Node", flexible_body("Panel", at, axes, {amplitude(0), amplitude(1)}, data_of(b)), "12"));
  }

private:
  void carry(const kanexpr::runtime::section_ids& on) {
    const frame_id load = rotated("L", on.frame, q[6], along(on.frame, 0.6, 0, 0.8));
    rigid_body("Load", offset("C", on.point, along(load, 0.3, 0.1, -0.2)), load, number(0.8),
               inertia(load, 0.3, 0.4, 0.5, 0.02, 0, 0));
    gravity(along(inertial_frame(), 0.3, -9.81, 1));
  }

  kanexpr::runtime::section_ids add_particles(const lumped::body& b) {
    point_id last{};
    for (std::size_t i = 0; i < b.particles.size(); ++i) {
      last = offset("P" + std::to_string(i), at, position_from_reference(b.particles[i]));
      particle("P" + std::to_string(i), last, number(b.particles[i].mass));
    }
    expression energy = number(0.0);
    add_energy_to(b, energy);
    potential_energy(energy);
    expression s[3]{number(0.0), number(0.0), number(0.0)};
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < amplitudes; ++k) s[i] += number(b.turns[index(k)][i] / 4) * amplitude(k);
    const frame_id turned = modified_rodrigues("Turned", axes, s[0], s[1], s[2]);
    mechanics::matrix3 cosines;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) cosines(i, j) = number(b.axes(i, j));
    return {direction_cosines("Node", turned, cosines), last};
  }
  void add_energy_to(const lumped::body& b, expression& energy) {
    for (int k = 0; k < amplitudes; ++k)
      for (int l = 0; l < amplitudes; ++l)
        energy += number(b.stiffness(k, l) / 2) * (amplitude(k) * amplitude(l));
  }

  mechanics::vector position_from_reference(const lumped::particle& p) {
    expression r[3]{number(0.0), number(0.0), number(0.0)};
    for (int i = 0; i < 3; ++i) {
      r[i] += number(p.place[i]);
      for (int k = 0; k < amplitudes; ++k) {
        r[i] += number(p.shape_of(k)[i]) * amplitude(k);
        for (int l = 0; l < amplitudes; ++l)
          r[i] += number(p.bend_of(k, l)[i] / 2) * (amplitude(k) * amplitude(l));
      }
    }
    return along(axes, r[0], r[1], r[2]);
  }
};

void expect_equal(const MatrixXd& found, const MatrixXd& expected, const std::string& what) {
  ASSERT_EQ(found.rows(), expected.rows());
  EXPECT_LE((found - expected).cwiseAbs().maxCoeff(), 1e-12 * (1 + expected.cwiseAbs().maxCoeff()))
      << what << "\nfound\n"
      << found << "\nexpected\n"
      << expected;
}

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

/// The derivatives of the equations with respect to the amplitudes and their rates.
kanexpr::symbolic::matrix derivatives(vehicle_base& of) {
  mechanics::equations equations(of.system());
  const kanexpr::symbolic::matrix residual = equations.get(quantity::inverse_dynamics);
  kanexpr::symbolic::matrix by(of.graph(), all, 2 * amplitudes);
  for (int i = 0; i < all; ++i)
    for (int k = 0; k < amplitudes; ++k) {
      const std::size_t symbol = static_cast<std::size_t>(rigid + k);
      by(i, k) = kanexpr::symbolic::differentiate(residual.entries[i], of.q[symbol]);
      by(i, amplitudes + k) = kanexpr::symbolic::differentiate(residual.entries[i], of.u[symbol]);
    }
  return by;
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
      "the numbers of Panel are incomplete: a list has a length that does not fit the number of amplitudes";
  EXPECT_EQ(mistake_after([](auto& d) { d.first_moment.coefficients = {1.0, 2.0}; }), incomplete);
  EXPECT_EQ(mistake_after([](auto& d) { d.stiffness = {}; }), incomplete);
  EXPECT_EQ(mistake_after([](auto& d) { d.stiffness[3] = std::numeric_limits<double>::quiet_NaN(); }),
            "Panel contains a number that is not finite");
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
