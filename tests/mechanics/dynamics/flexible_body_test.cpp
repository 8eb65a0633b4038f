// builds: clang++ all
// Flexible bodies whose integrals are sums over particles, compared with models of the same particles.
#include "numbers_of.hpp"

#include <Eigen/Core>
#include <Eigen/Dense>
#include <gtest/gtest.h>
#include <kanexpr/mechanics/equations.hpp>
#include <kanexpr/runtime/builder.hpp>

#include <cmath>
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
using kanexpr::runtime::vector;
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

// A builder whose expressions are evaluated at random states.
struct evaluated : builder {
  VectorXd q_now, u_now, udot_now;
  std::vector<expression> q, u;

  evaluated(int coordinates, mechanics::method by) : builder("N"), coordinates_(coordinates) {
    for (int i = 0; i < coordinates; ++i) q.push_back(coordinate("q" + std::to_string(i)));
    if (by == mechanics::method::lagrange) rates_as_speeds();
    for (int i = 0; i < coordinates; ++i)
      u.push_back(by == mechanics::method::lagrange ? dot(q[static_cast<std::size_t>(i)])
                                                    : speed("u" + std::to_string(i)));
  }

  void draw(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> between(-1, 1);
    for (VectorXd* v : {&q_now, &u_now, &udot_now})
      *v = VectorXd::NullaryExpr(coordinates_, [&] { return between(random); });
  }

  MatrixXd numbers(const kanexpr::symbolic::matrix& wanted) {
    const auto value_of = [&](const kanexpr::lower::load& l) {
      using kanexpr::symbolic::symbol_kind;
      if (l.from == symbol_kind::coordinate) return q_now[l.position];
      if (l.from == symbol_kind::speed) return u_now[l.position];
      if (l.from == symbol_kind::speed_rate) return udot_now[l.position];
      return 0.3 * (l.position + 1); // a direction or a weight
    };
    return numbers_of(wanted, value_of);
  }

private:
  int coordinates_;
};

enum class kind { flexible, particles };
enum class speeds { rates, general };

// A free body and a second one on a hinge that its deformation moves and turns, both flexible, with a rigid
// body at the end.
struct chain : evaluated {
  point_id end_point{};

  chain(kind bodies, mechanics::method by, speeds chosen = speeds::rates) : evaluated(11, by) {
    if (by == mechanics::method::kane) relate(chosen);
    const frame_id n = inertial_frame();
    const point_id o = origin("O"), a = held(offset("A", o, along(n, q[0], q[1], q[2])), n, "A");
    const frame_id base = body_fixed("B", n, "xyz", q[3], q[4], q[5]);
    if (chosen == speeds::general) {
      angular_velocity(base, n, along(base, u[3], u[4], u[5]));
      kinematics_of(base, n);
    }
    const polynomials first{*this, {q[6], q[7]}}, second{*this, {q[9], q[10]}};
    const point_id inside = offset("I", a, along(base, 0.2, -0.1, 0.3)); // fixed in the frame of the body
    add("One", bodies, inside, base, first, particles_of(1));
    const frame_id tilted = rotated("C", base, first.linear(0, 0.4, -0.7), along(base, 0, 0, 1));
    const particle_of_body place{0, {0.9, 0.2, -0.1}, particles_of(3)[0].shape};
    const mechanics::components r = first.position(place);
    const point_id hinge = held(offset("H", inside, along(base, r.x, r.y, r.z)), base, "H");
    const frame_id arm = rotated("D", tilted, q[8], along(tilted, 0.6, 0, 0.8));
    const frame_id aslant = rotated("S", arm, number(0.7), along(arm, 0, 0, 1));
    add("Two", bodies, hinge, aslant, second, particles_of(2));
    const mechanics::components end = second.position(particles_of(4)[0]);
    const frame_id tip = rotated("E", arm, second.linear(0.1, 0.3, 0.5), along(arm, 0, 1, 0));
    end_point = offset("T", hinge, along(arm, end.x, end.y, end.z));
    rigid_body("Load", end_point, tip, number(0.8), inertia(tip, 0.3, 0.4, 0.5, 0.02, 0, 0));
    gravity(along(n, 0.3, -9.81, 1));
    force(hinge, along(n, 1, 0, q[0]));
  }

  // Guides the end in a slot, and couples two deformations with the hinge.
  void close() {
    const vector end = position_of(end_point, point_id{0});
    configuration_constraint(dot(end, along(inertial_frame(), 1, 0.5, 0)) - 0.2);
    velocity_constraint(0.3 * u[6] + u[9] - q[1] * u[8]);
  }

private:
  // The same point with auxiliary speeds, which bring the force on it into evidence.
  point_id held(point_id at, frame_id in, const std::string& called) {
    if (mechanism().derived_by == mechanics::method::lagrange) return at;
    const point_id own = offset(called + "*", at, {});
    const expression along_x = auxiliary_speed(called + "x"), along_y = auxiliary_speed(called + "y"),
                     along_z = auxiliary_speed(called + "z");
    velocity_from_parent(own, in, along(in, along_x, along_y, along_z));
    return own;
  }

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

constexpr quantity of_bodies[]{quantity::mass_matrix,
                               quantity::forcing,
                               quantity::kinetic_energy,
                               quantity::potential_energy,
                               quantity::linear_momentum,
                               quantity::angular_momentum,
                               quantity::center_of_mass,
                               quantity::active_forces,
                               quantity::inertia_forces,
                               quantity::inverse_dynamics,
                               quantity::gravity_compensation,
                               quantity::generalized_momenta,
                               quantity::unreduced_forces,
                               quantity::noncontributing_forces,
                               quantity::udot};

constexpr quantity of_linearization[]{quantity::state_matrix,           quantity::implicit_mass_matrix,
                                      quantity::implicit_state_matrix,  quantity::weighted_gradient,
                                      quantity::directional_derivative, quantity::weighted_hessian_product};

void expect_same_results(evaluated& found, evaluated& expected, const std::vector<quantity>& wanted) {
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

TEST(flexible_body, is_constrained_like_its_particles) {
  chain body(kind::flexible, mechanics::method::kane), particles(kind::particles, mechanics::method::kane);
  for (chain* each : {&body, &particles}) each->close();
  expect_same_results(body, particles,
                      {quantity::mass_matrix, quantity::forcing, quantity::udot, quantity::multipliers,
                       quantity::noncontributing_forces});
}

TEST(flexible_body, is_linearized_like_its_particles) {
  chain body(kind::flexible, mechanics::method::kane), particles(kind::particles, mechanics::method::kane);
  expect_same_results(body, particles, {std::begin(of_linearization), std::end(of_linearization)});
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

// ---- integrals to the second order

using mode_pair = Eigen::Matrix<double, 3, 4>; // ∂²r/∂q_k∂q_l in column 2 k + l

// A particle at place + Σ shape_k q_k + ½ Σ bend_kl q_k q_l.
struct bending_particle : particle_of_body {
  mode_pair bend;

  Vector3d position(const Eigen::Vector2d& q) const { return place + shape * q + slope(q, 0.5) * q; }
  Eigen::Matrix<double, 3, 2> slope(const Eigen::Vector2d& q, double factor) const {
    Eigen::Matrix<double, 3, 2> by;
    for (int k = 0; k < 2; ++k) by.col(k) = factor * bend.middleCols<2>(k == 0 ? 0 : 2) * q;
    return by;
  }
  Eigen::Matrix<double, 3, 2> derivative(const Eigen::Vector2d& q) const { return shape + slope(q, 1); }
};

std::vector<bending_particle> bending_particles() {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> between(-1, 1);
  std::vector<bending_particle> all;
  for (const particle_of_body& p : particles_of(8)) {
    mode_pair bend = mode_pair::NullaryExpr([&] { return between(random); });
    bend.col(2) = bend.col(1);
    all.push_back({p, bend});
  }
  return all;
}

// c + l·q + q·s·q
struct quadratic {
  double constant = 0;
  Eigen::Vector2d linear = Eigen::Vector2d::Zero();
  Eigen::Matrix2d square = Eigen::Matrix2d::Zero();

  quadratic& operator+=(const quadratic& other) {
    constant += other.constant, linear += other.linear, square += other.square;
    return *this;
  }
  friend quadratic operator*(double factor, const quadratic& a) {
    return {factor * a.constant, factor * a.linear, factor * a.square};
  }
  // Without terms of higher than the second order.
  friend quadratic operator*(const quadratic& a, const quadratic& b) {
    return {a.constant * b.constant, a.constant * b.linear + b.constant * a.linear,
            a.constant * b.square + b.constant * a.square + a.linear * b.linear.transpose()};
  }
  quadratic to_first_order() const { return {constant, linear, Eigen::Matrix2d::Zero()}; }

  expression of(builder& b, const std::vector<expression>& q) const {
    expression sum = b.number(constant) + (b.number(linear(0)) * q[0] + b.number(linear(1)) * q[1]);
    sum += b.number(square(0, 0)) * (q[0] * q[0]);
    sum += b.number(square(0, 1) + square(1, 0)) * (q[0] * q[1]);
    sum += b.number(square(1, 1)) * (q[1] * q[1]);
    return sum;
  }
};

flexible_integrals truncated_integrals(const std::vector<bending_particle>& particles, builder& b,
                                       const std::vector<expression>& q) {
  double mass = 0;
  quadratic first[3], inertia[6], angular[2][3];
  Eigen::Matrix2d modal = Eigen::Matrix2d::Zero();
  for (const bending_particle& p : particles) {
    quadratic r[3], by[2][3];
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 2; ++k)
        by[k][i] = {p.shape(i, k), p.bend.row(i).segment<2>(k == 0 ? 0 : 2).transpose(),
                    Eigen::Matrix2d::Zero()};
      Eigen::Matrix2d half;
      half << by[0][i].linear.transpose() / 2, by[1][i].linear.transpose() / 2;
      r[i] = {p.place(i), p.shape.row(i).transpose(), half};
    }
    mass += p.mass;
    modal += p.mass * p.shape.transpose() * p.shape;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      first[i] += p.mass * r[i];
      inertia[i] += p.mass * (r[j] * r[j]);
      inertia[i] += p.mass * (r[k] * r[k]);
      inertia[3 + i] += -p.mass * (r[i] * r[j]);
      for (int n = 0; n < 2; ++n) {
        angular[n][i] += p.mass * (r[j] * by[n][k]).to_first_order();
        angular[n][i] += -p.mass * (r[k] * by[n][j]).to_first_order();
      }
    }
  }
  const auto of = [&](const quadratic& a) { return a.of(b, q); };
  return {.mass = mass,
          .first_moment = {of(first[0]), of(first[1]), of(first[2])},
          .inertia = {of(inertia[0]), of(inertia[1]), of(inertia[2]), of(inertia[3]), of(inertia[4]),
                      of(inertia[5])},
          .angular = {{of(angular[0][0]), of(angular[0][1]), of(angular[0][2])},
                      {of(angular[1][0]), of(angular[1][1]), of(angular[1][2])}},
          .modal_mass = {{modal(0, 0), modal(0, 1)}, {modal(1, 0), modal(1, 1)}},
          .stiffness = {{7.0, 0.4}, {0.4, 5.0}}};
}

// A free flexible body with a rigid body at one of its particles.
struct free_body : evaluated {
  static constexpr double d[2][2]{{0.3, 0.1}, {0.1, 0.2}};

  explicit free_body(mechanics::method by, bool is_damped = false, bool has_load = true) : evaluated(8, by) {
    for (std::size_t i = 0; i < 8 && by == mechanics::method::kane; ++i) kinematic_equation(dot(q[i]) - u[i]);
    const frame_id n = inertial_frame(), own = body_fixed("B", n, "xyz", q[3], q[4], q[5]);
    const point_id a = offset("A", origin("O"), along(n, q[0], q[1], q[2]));
    flexible_integrals data = truncated_integrals(bending_particles(), *this, {q[6], q[7]});
    if (is_damped) data.damping = {{d[0][0], d[0][1]}, {d[1][0], d[1][1]}};
    flexible_body("Body", a, own, {q[6], q[7]}, data);
    const mechanics::components r = polynomials{*this, {q[6], q[7]}}.position(particles_of(3)[0]);
    const frame_id tip = rotated("C", own, number(0.4) * q[6], along(own, 0, 1, 0));
    if (has_load)
      rigid_body("Load", offset("P", a, along(own, r.x, r.y, r.z)), tip, number(0.8),
                 inertia(tip, 0.3, 0.4, 0.5, 0.02, 0, 0));
  }
};

TEST(flexible_body, has_the_same_equations_by_both_methods) {
  free_body kane(mechanics::method::kane, true), lagrange(mechanics::method::lagrange, true);
  expect_same_results(kane, lagrange,
                      {quantity::mass_matrix, quantity::forcing, quantity::inverse_dynamics,
                       quantity::coriolis, quantity::generalized_momenta});
}

TEST(flexible_body, conserves_energy_and_momenta) {
  for (const bool is_damped : {false, true}) {
    free_body b(mechanics::method::kane, is_damped);
    ASSERT_EQ(b.check().view(), "");
    mechanics::equations e(b.system());
    const kanexpr::symbolic::matrix udot = e.get(quantity::udot);
    kanexpr::symbolic::matrix rates(b.graph(), 7, 1);
    const expression kinetic = e.get(quantity::kinetic_energy).entries[0],
                     potential = e.get(quantity::potential_energy).entries[0];
    rates.entries[0] = e.moving().rate(kinetic) + e.moving().rate(potential);
    for (int i = 0; i < 3; ++i) {
      rates.entries[1 + i] = e.moving().rate(e.get(quantity::linear_momentum).entries[i]);
      rates.entries[4 + i] = e.moving().rate(e.get(quantity::angular_momentum).entries[i]);
    }
    for (const unsigned seed : {1u, 2u, 3u}) {
      b.draw(seed);
      b.udot_now = b.numbers(udot);
      VectorXd expected = VectorXd::Zero(7);
      for (int k = 0; k < 2 && is_damped; ++k)
        for (int l = 0; l < 2; ++l) expected(0) -= free_body::d[k][l] * b.u_now(6 + k) * b.u_now(6 + l);
      const double size = 1 + b.udot_now.cwiseAbs().maxCoeff();
      EXPECT_LE((b.numbers(rates) - expected).cwiseAbs().maxCoeff(), 1e-11 * size);
    }
  }
}

// The kinetic energy differs from that of the particles by terms of the third order.
TEST(flexible_body, is_exact_to_the_second_order) {
  free_body b(mechanics::method::kane, false, false);
  ASSERT_EQ(b.check().view(), "");
  mechanics::equations e(b.system());
  b.draw(1);
  const VectorXd q = b.q_now, u = b.u_now;
  double before = 0;
  for (const double size : {1e-2, 5e-3, 2.5e-3}) {
    b.q_now.tail(2) = size * q.tail(2);
    b.u_now.tail(2) = size * u.tail(2);
    const auto numbers = [&](const mechanics::components& v) -> Vector3d {
      kanexpr::symbolic::matrix m(b.graph(), 3, 1);
      m.entries = {v.x, v.y, v.z};
      return b.numbers(m);
    };
    const Vector3d v =
        numbers(e.moving().velocity(e.skeleton_used().station_of_point[1], 3)); // along the axes of B
    const Vector3d w = numbers(e.moving().angular_velocity(3));
    double exact = 0;
    for (const bending_particle& p : bending_particles()) {
      const Eigen::Vector2d now = b.q_now.tail(2), rates = b.u_now.tail(2);
      exact += p.mass * (v + w.cross(p.position(now)) + p.derivative(now) * rates).squaredNorm() / 2;
    }
    const double apart = std::abs(b.numbers(e.get(quantity::kinetic_energy))(0) - exact);
    if (before > 0) {
      EXPECT_NEAR(std::log2(before / apart), 3, 0.05);
    }
    before = apart;
  }
}

// ---- mistakes

// A hanging body with two amplitudes, described by `data`.
struct given : builder {
  expression q = coordinate("q"), a1 = coordinate("a1"), a2 = coordinate("a2");
  expression u = speed("u"), v1 = speed("v1"), v2 = speed("v2"), m = parameter("m"), f = input("F");
  point_id o = origin("O");
  frame_id own = rotated("B", inertial_frame(), q, along(inertial_frame(), 0, 0, 1));
  flexible_integrals data{.mass = m,
                          .first_moment = {m * 1.0, 0.0, 0.0},
                          .inertia = {0.0, m * 0.4, m * 0.4, 0.0, 0.0, 0.0},
                          .angular = {{0.0, 0.0, 0.5}, {0.0, 0.0, 0.1}},
                          .modal_mass = {{1.0, 0.1}, {0.1, 2.0}}};

  given() : builder("N") {
    kinematic_equation(dot(q) - u);
    kinematic_equation(dot(a1) - v1);
    kinematic_equation(dot(a2) - v2);
    used_elsewhere(f);
    used_elsewhere(m);
  }
  std::string mistake_of(const std::vector<expression>& amplitudes) {
    flexible_body("Beam", o, own, amplitudes, data);
    return std::string(check().view());
  }
  std::string mistake_found() { return mistake_of({a1, a2}); }
};

template <class Change>
std::string mistake_after(const Change& change) {
  given b;
  change(b);
  return b.mistake_found();
}

TEST(flexible_body, must_have_amplitudes_of_its_own) {
  given first, second, third;
  EXPECT_EQ(first.mistake_of({first.a1, first.u}), "amplitude 2 of Beam is not a coordinate");
  EXPECT_EQ(second.mistake_of({second.a1, second.a1}), "a1 is listed twice among the amplitudes of Beam");
  third.flexible_body("Mast", third.o, third.own, {third.a2, third.a1}, third.data);
  EXPECT_EQ(third.mistake_found(), "a1 is an amplitude of both Mast and Beam");
}

TEST(flexible_body, must_have_a_name_of_its_own) {
  given first, second;
  first.particle("Beam", first.o, first.m);
  EXPECT_EQ(first.mistake_found(), "two bodies are called Beam");
  EXPECT_EQ(second.mistake_found(), "");
  second.particle("Beam", second.o, second.m);
  EXPECT_EQ(second.check().view(), "two bodies are called Beam");
}

TEST(flexible_body, must_have_integrals_of_its_amplitudes_and_parameters) {
  EXPECT_EQ(mistake_after([](given&) {}), "");
  EXPECT_EQ(mistake_after([](given& b) { b.data.mass = b.m + b.a1; }),
            "the mass of Beam contains the coordinate a1; it may contain only parameters");
  EXPECT_EQ(mistake_after([](given& b) { b.data.mass = b.m * b.f; }),
            "the mass of Beam contains the input F; it may contain only parameters");
  EXPECT_EQ(mistake_after([](given& b) { b.data.mass = b.m * b.time(); }),
            "the mass of Beam contains time; it may contain only parameters");
  EXPECT_EQ(mistake_after([](given& b) { b.data.first_moment[1] = b.m * b.q; }),
            "the first moment of Beam contains the coordinate q; it may contain only parameters and the "
            "amplitudes of the body");
  EXPECT_EQ(mistake_after([](given& b) { b.data.inertia[2] = b.m + b.v1 * b.v1; }),
            "the inertia of Beam contains the speed v1; it may contain only parameters and the amplitudes of "
            "the body");
  EXPECT_EQ(mistake_after([](given& b) { b.data.angular[0][0] = b.m * b.dot(b.a1); }),
            "an angular integral of Beam contains the rate of coordinate a1; it may contain only parameters "
            "and the amplitudes of the body");
  EXPECT_EQ(mistake_after([](given& b) { b.data.modal_mass[0][0] = b.m + b.a2; }),
            "the modal mass of Beam contains the coordinate a2; it may contain only parameters");
}

TEST(flexible_body, must_have_a_mass) {
  EXPECT_EQ(mistake_after([](given& b) { b.data.mass = 0.0; }), "the flexible body Beam has no mass");
  EXPECT_EQ(mistake_after([](given& b) { b.data.mass = -b.m; }), "the mass of Beam is negative");
  EXPECT_EQ(mistake_after([](given& b) { b.data.modal_mass[1][1] = 0.0; }),
            "the modal mass of a2, an amplitude of Beam, is not positive");
  EXPECT_EQ(mistake_after([](given& b) { b.data.modal_mass[1][0] = 0.2; }),
            "the modal mass of Beam is not symmetric");
  EXPECT_EQ(mistake_after([](given& b) { b.data.modal_mass = {{1.0, 1.5}, {1.5, 2.0}}; }),
            "the modal mass of Beam is not positive definite: some deformation has no kinetic energy, or a "
            "negative one");
  EXPECT_EQ(mistake_after([](given& b) {
              b.data.mass = 2.0;
              b.data.first_moment = {1.0, 0.0, 0.0};
              b.data.inertia = {0.0, 0.4, 0.4, 0.0, 0.0, 0.0};
            }),
            "the integrals of Beam belong to no distribution of mass: the kinetic energy of some motion is "
            "negative");
}

TEST(flexible_body, must_have_matrices_of_the_size_of_its_amplitudes) {
  EXPECT_EQ(mistake_after([](given& b) { b.data.angular.pop_back(); }),
            "expected an angular integral for each of the 2 amplitudes of Beam, got 1");
  EXPECT_EQ(mistake_after([](given& b) { b.data.modal_mass.pop_back(); }),
            "the modal mass of Beam must be a matrix with a row and a column for each of the 2 amplitudes");
  EXPECT_EQ(mistake_after([](given& b) { b.data.stiffness = {{1.0, 0.0}, {0.0}}; }),
            "the stiffness of Beam must be a matrix with a row and a column for each of the 2 amplitudes");
  EXPECT_EQ(mistake_after([](given& b) { b.data.stiffness = {{1.0, 0.1}, {0.2, 1.0}}; }),
            "the stiffness of Beam is not symmetric");
  EXPECT_EQ(mistake_after([](given& b) { b.data.modal_mass = {{1.0, 1e-12}, {-1e-12, 2.0}}; }), "");
  EXPECT_EQ(
      mistake_after([](given& b) { b.data.stiffness = {{1.0, b.m * (b.m + 1)}, {b.m * b.m + b.m, 1.0}}; }),
      "");
  EXPECT_EQ(mistake_after([](given& b) { b.data.damping = {{1.0}}; }),
            "the damping of Beam must be a matrix with a row and a column for each of the 2 amplitudes");
  EXPECT_EQ(mistake_after([](given& b) { b.data.damping = {{b.dot(b.u), 0.0}, {0.0, 1.0}}; }),
            "the modal damping of a1 contains the rate of speed u");
}

TEST(flexible_body, has_no_inertial_parameters) {
  for (const quantity each : {quantity::inertial_parameters, quantity::regressor}) {
    given b;
    EXPECT_EQ(b.mistake_found(), "");
    kanexpr::model model = kanexpr::derive(b);
    EXPECT_EQ(model.get(each).entries.size(), 0);
    EXPECT_EQ(model.mistake(),
              "the inertial parameters and the regressor require rigid bodies; Beam is flexible");
  }
}

} // namespace
