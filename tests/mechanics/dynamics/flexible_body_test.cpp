// Flexible bodies whose integrals are sums over particles, compared with models of the same particles.
#include <Eigen/Core>
#include <Eigen/Dense>
#include <gtest/gtest.h>
#include <kanexpr/mechanics/equations.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/runtime/interpreter.hpp>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace {

namespace mechanics = kanexpr::mechanics;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using kanexpr::runtime::builder;
using kanexpr::runtime::flexible_integrals;
using kanexpr::runtime::frame_id;
using kanexpr::runtime::number_or_expression;
using kanexpr::runtime::point_id;
using kanexpr::symbolic::expression;
using mechanics::quantity;

// A particle at place + Σ shape_k q_k from the reference point.
struct particle_of_body {
  double mass;
  Vector3d place;
  Eigen::Matrix<double, 3, 2> shape;
};

// The sum of some coordinates, weighted by numbers.
struct polynomials {
  builder& b;
  std::vector<expression> q;

  expression linear(double constant, double first, double second) const {
    return b.number(constant) + (b.number(first) * q[0] + b.number(second) * q[1]);
  }
  mechanics::components position(const particle_of_body& p) const {
    mechanics::components r;
    for (int i = 0; i < 3; ++i) r[i] = linear(p.place(i), p.shape(i, 0), p.shape(i, 1));
    return r;
  }
};

flexible_integrals integrals_over(const std::vector<particle_of_body>& particles, const polynomials& by) {
  builder& b = by.b;
  const expression zero = b.number(0.0);
  expression mass = zero, first[3]{zero, zero, zero}, inertia[6]{zero, zero, zero, zero, zero, zero};
  expression angular[2][3]{{zero, zero, zero}, {zero, zero, zero}};
  Eigen::Matrix2d modal = Eigen::Matrix2d::Zero();
  for (const particle_of_body& p : particles) {
    const mechanics::components r = by.position(p);
    const expression m = b.number(p.mass);
    mass += m;
    modal += p.mass * p.shape.transpose() * p.shape;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      first[i] += m * r[i];
      inertia[i] += m * (r[j] * r[j] + r[k] * r[k]);
      inertia[3 + i] -= m * (r[i] * r[j]);
      for (int n = 0; n < 2; ++n)
        angular[n][i] += m * (b.number(p.shape(k, n)) * r[j] - b.number(p.shape(j, n)) * r[k]);
    }
  }
  return {.mass = mass,
          .first_moment = {first[0], first[1], first[2]},
          .inertia = {inertia[0], inertia[1], inertia[2], inertia[3], inertia[4], inertia[5]},
          .angular = {{angular[0][0], angular[0][1], angular[0][2]},
                      {angular[1][0], angular[1][1], angular[1][2]}},
          .modal_mass = {{modal(0, 0), modal(0, 1)}, {modal(1, 0), modal(1, 1)}},
          .stiffness = {{7.0, 0.4}, {0.4, 5.0}}};
}

std::vector<particle_of_body> particles_of(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> between(-1, 1);
  std::vector<particle_of_body> all(7);
  for (particle_of_body& p : all) {
    p.mass = 1.5 + between(random);
    for (int i = 0; i < 3; ++i) {
      p.place(i) = between(random);
      for (int k = 0; k < 2; ++k) p.shape(i, k) = between(random);
    }
  }
  return all;
}

enum class kind { flexible, particles };
enum class speeds { rates, general };

// A free body and a second one on a hinge that its deformation moves and turns, both flexible, with a rigid
// body at the end.
struct chain : builder {
  VectorXd q_now, u_now, udot_now;
  std::vector<expression> q, u;

  chain(kind bodies, mechanics::method by, speeds chosen = speeds::rates) : builder("N") {
    for (int i = 0; i < 11; ++i) q.push_back(coordinate("q" + std::to_string(i)));
    if (by == mechanics::method::lagrange) {
      rates_as_speeds();
      for (const expression& each : q) u.push_back(dot(each));
    } else {
      for (int i = 0; i < 11; ++i) u.push_back(speed("u" + std::to_string(i)));
      relate(chosen);
    }
    const frame_id n = inertial_frame();
    const point_id o = origin("O"), a = offset("A", o, along(n, q[0], q[1], q[2]));
    const frame_id base = body_fixed("B", n, "xyz", q[3], q[4], q[5]);
    if (chosen == speeds::general) {
      angular_velocity(base, n, along(base, u[3], u[4], u[5]));
      kinematics_of(base, n);
    }
    const polynomials first{*this, {q[6], q[7]}}, second{*this, {q[9], q[10]}};
    add("One", bodies, a, base, first, particles_of(1));
    const frame_id tilted = rotated("C", base, first.linear(0, 0.4, -0.7), along(base, 0, 0, 1));
    const particle_of_body place{0, {0.9, 0.2, -0.1}, particles_of(3)[0].shape};
    const mechanics::components r = first.position(place);
    const point_id hinge = offset("H", a, along(base, r.x, r.y, r.z));
    const frame_id arm = rotated("D", tilted, q[8], along(tilted, 0.6, 0, 0.8));
    add("Two", bodies, hinge, arm, second, particles_of(2));
    const mechanics::components end = second.position(particles_of(4)[0]);
    const frame_id tip = rotated("E", arm, second.linear(0.1, 0.3, 0.5), along(arm, 0, 1, 0));
    rigid_body("Load", offset("T", hinge, along(arm, end.x, end.y, end.z)), tip, number(0.8),
               inertia(tip, 0.3, 0.4, 0.5, 0.02, 0, 0));
    gravity(along(n, 0.3, -9.81, 1));
    force(hinge, along(n, 1, 0, q[0]));
    draw(5);
  }

  void draw(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> between(-1, 1);
    for (VectorXd* v : {&q_now, &u_now, &udot_now})
      *v = VectorXd::NullaryExpr(11, [&] { return between(random); });
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

private:
  void relate(speeds chosen) {
    for (int i = 0; i < 11; ++i) {
      if (chosen == speeds::general && i >= 3 && i < 6) continue;
      const bool is_mixed = chosen == speeds::general && (i == 6 || i == 10);
      kinematic_equation(dot(q[static_cast<std::size_t>(i)]) -
                         (is_mixed ? (1 + q[0] * q[0]) * u[static_cast<std::size_t>(i)] + u[3] * q[7]
                                   : u[static_cast<std::size_t>(i)]));
    }
  }

  void add(const std::string& called, kind bodies, point_id at, frame_id frame, const polynomials& by,
           const std::vector<particle_of_body>& particles) {
    const flexible_integrals data = integrals_over(particles, by);
    if (bodies == kind::flexible) return flexible_body(called, at, frame, by.q, data);
    potential_energy(number(3.5) * by.q[0] * by.q[0] + number(2.5) * by.q[1] * by.q[1] +
                     number(0.4) * by.q[0] * by.q[1]);
    for (std::size_t i = 0; i < particles.size(); ++i) {
      const mechanics::components r = by.position(particles[i]);
      const std::string name = called + std::to_string(i);
      particle(name, offset(name, at, along(frame, r.x, r.y, r.z)), number(particles[i].mass));
    }
  }
};

void expect_equal(const MatrixXd& found, const MatrixXd& expected, const std::string& what) {
  ASSERT_EQ(found.rows(), expected.rows());
  EXPECT_LE((found - expected).cwiseAbs().maxCoeff(), 1e-12 * (1 + expected.cwiseAbs().maxCoeff()))
      << what << "\nfound\n"
      << found << "\nexpected\n"
      << expected;
}

constexpr quantity of_bodies[]{quantity::mass_matrix,          quantity::forcing,
                               quantity::kinetic_energy,       quantity::potential_energy,
                               quantity::linear_momentum,      quantity::angular_momentum,
                               quantity::center_of_mass,       quantity::active_forces,
                               quantity::inertia_forces,       quantity::inverse_dynamics,
                               quantity::gravity_compensation, quantity::generalized_momenta,
                               quantity::unreduced_forces};

void expect_same_results(chain& found, chain& expected, const std::vector<quantity>& wanted) {
  ASSERT_EQ(found.check().view(), "");
  ASSERT_EQ(expected.check().view(), "");
  mechanics::equations by_body(found.system()), by_particles(expected.system());
  for (const unsigned seed : {1u, 2u, 3u}) {
    found.draw(seed);
    expected.draw(seed);
    for (const quantity each : wanted)
      expect_equal(found.numbers(by_body.get(each)), expected.numbers(by_particles.get(each)),
                   std::string(mechanics::row_of(each).called));
  }
}

TEST(flexible_body, equals_its_particles_by_kanes_method) {
  chain body(kind::flexible, mechanics::method::kane), particles(kind::particles, mechanics::method::kane);
  expect_same_results(body, particles, {std::begin(of_bodies), std::end(of_bodies)});
}

TEST(flexible_body, equals_its_particles_for_general_speeds) {
  chain body(kind::flexible, mechanics::method::kane, speeds::general),
      particles(kind::particles, mechanics::method::kane, speeds::general);
  expect_same_results(body, particles, {std::begin(of_bodies), std::end(of_bodies)});
}

TEST(flexible_body, equals_its_particles_by_lagranges_method) {
  chain body(kind::flexible, mechanics::method::lagrange),
      particles(kind::particles, mechanics::method::kane);
  expect_same_results(
      body, particles,
      {quantity::mass_matrix, quantity::forcing, quantity::active_forces, quantity::inverse_dynamics});
}

} // namespace
