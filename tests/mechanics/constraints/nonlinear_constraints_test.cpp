// builds: clang++
// Constraints that are not linear in the speeds, compared with Gauss's principle of least constraint.
#include <kanexpr/lower/complex_math.hpp>
#include <kanexpr/mechanics/motion/known_motion.hpp>
#include <kanexpr/mechanics/motion/observe.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/units/possible_unit.hpp>
#include <kanexpr/units/si.hpp>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/QR>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>
#include <string>
#include <vector>

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using kanexpr::derive;
using kanexpr::model;
using kanexpr::mechanics::quantity;
using kanexpr::runtime::builder;
using kanexpr::symbolic::expression;
using complex = std::complex<double>;

constexpr double step = 1e-30; // of complex steps

VectorXd random_numbers(std::mt19937_64& source, Index count, double reach) {
  std::uniform_real_distribution<double> unit(-reach, reach);
  return VectorXd::NullaryExpr(count, [&] { return unit(source); });
}

// A double pendulum on a cart. The squared speed of the second bob is given as a function of time; a linear
// constraint may be added.
struct pendulums_on_cart : builder {
  expression s, a, b, us, ua, ub, m0, m1, m2, l1, l2, g, c;

  explicit pendulums_on_cart(bool by_lagrange, bool has_linear) : builder("N") {
    s = coordinate("s"), a = coordinate("a"), b = coordinate("b");
    if (by_lagrange) {
      rates_as_speeds();
      us = dot(s), ua = dot(a), ub = dot(b);
    } else {
      us = speed("us"), ua = speed("ua"), ub = speed("ub");
      kinematic_equation(dot(s) - us), kinematic_equation(dot(a) - ua), kinematic_equation(dot(b) - ub);
    }
    m0 = parameter("m0"), m1 = parameter("m1"), m2 = parameter("m2"), l1 = parameter("l1");
    l2 = parameter("l2"), g = parameter("g"), c = parameter("c");
    const auto n = inertial_frame();
    const auto z = along(n, 0, 0, 1);
    const auto first = rotated("A", n, a, z), second = rotated("B", n, b, z);
    const auto cart = offset("C", origin("O"), along(n, 0, s, 0)),
               bob1 = offset("P", cart, along(first, l1, 0, 0)),
               bob2 = offset("Q", bob1, along(second, l2, 0, 0));
    particle("Cart", cart, m0), particle("Bob1", bob1, m1), particle("Bob2", bob2, m2);
    gravity(along(n, g, 0, 0)); // x points down
    if (has_linear) velocity_constraint(us + cos(a) * ua - c);
    const expression x = -l1 * sin(a) * ua - l2 * sin(b) * ub, y = us + l1 * cos(a) * ua + l2 * cos(b) * ub;
    velocity_constraint(x * x + y * y - (c + sin(time()) / 5) * (c + sin(time()) / 5));
  }
};

// The same system in plain numbers, with p = [m0; m1; m2; l1; l2; g; c].
struct by_hand {
  const VectorXd& p;
  bool has_linear;

  int rows() const { return has_linear ? 2 : 1; }

  Eigen::Matrix3d mass(const VectorXd& q) const {
    const double a = q(1), b = q(2), m12 = p(1) + p(2), l1 = p(3), l2 = p(4);
    Eigen::Matrix3d m;
    m << p(0) + m12, m12 * l1 * std::cos(a), p(2) * l2 * std::cos(b), // by symmetry
        m12 * l1 * std::cos(a), m12 * l1 * l1, p(2) * l1 * l2 * std::cos(a - b), p(2) * l2 * std::cos(b),
        p(2) * l1 * l2 * std::cos(a - b), p(2) * l2 * l2;
    return m;
  }

  Eigen::Vector3d force(const VectorXd& q, const VectorXd& u) const {
    const double a = q(1), b = q(2), m12 = p(1) + p(2), l1 = p(3), l2 = p(4), g = p(5);
    const double turning = p(2) * l1 * l2 * std::sin(a - b);
    return {m12 * l1 * std::sin(a) * u(1) * u(1) + p(2) * l2 * std::sin(b) * u(2) * u(2),
            -m12 * g * l1 * std::sin(a) - turning * u(2) * u(2),
            -p(2) * g * l2 * std::sin(b) + turning * u(1) * u(1)};
  }

  Eigen::VectorXcd residual(complex t, const Eigen::VectorXcd& q, const Eigen::VectorXcd& u) const {
    const double l1 = p(3), l2 = p(4), c = p(6);
    const complex x = -l1 * std::sin(q(1)) * u(1) - l2 * std::sin(q(2)) * u(2),
                  y = u(0) + l1 * std::cos(q(1)) * u(1) + l2 * std::cos(q(2)) * u(2),
                  speed = c + std::sin(t) / 5.0;
    Eigen::VectorXcd all(rows());
    if (has_linear) all(0) = u(0) + std::cos(q(1)) * u(1) - c;
    all(rows() - 1) = x * x + y * y - speed * speed;
    return all;
  }

  // Exact derivatives by complex steps.
  MatrixXd jacobian(double t, const VectorXd& q, const VectorXd& u) const {
    MatrixXd j(rows(), 3);
    for (Index i = 0; i < 3; ++i) {
      Eigen::VectorXcd moved = u;
      moved(i) += complex(0, step);
      j.col(i) = residual(t, q, moved).imag() / step;
    }
    return j;
  }
  VectorXd bias(double t, const VectorXd& q, const VectorXd& u) const {
    const complex ahead(0, step);
    return residual(t + ahead, q + ahead * u, u).imag() / step;
  }

  // Gauss's principle: u̇ minimizes (u̇ − a)ᵀ M (u̇ − a)/2 with M a = f, subject to J u̇ = −γ. With M = L Lᵀ and
  // y = Lᵀ (u̇ − a), y is the solution of J L⁻ᵀ y = −γ − J a with the least norm.
  VectorXd accelerations(double t, const VectorXd& q, const VectorXd& u) const {
    const Eigen::LLT<Eigen::Matrix3d> factors(mass(q));
    const Eigen::Vector3d free = factors.solve(force(q, u));
    const MatrixXd j = jacobian(t, q, u);
    const MatrixXd inverse = factors.matrixU().solve(MatrixXd::Identity(3, 3));
    const Eigen::HouseholderQR<MatrixXd> rows(MatrixXd((j * inverse).transpose()));
    const MatrixXd q_of_rows = rows.householderQ() * MatrixXd::Identity(3, j.rows()),
                   r_of_rows = rows.matrixQR().topRows(j.rows()).triangularView<Eigen::Upper>();
    const VectorXd y =
        q_of_rows * MatrixXd(r_of_rows.transpose()).partialPivLu().solve(-bias(t, q, u) - j * free);
    return free + inverse * y;
  }
};

std::string text(const kanexpr::units::possible_unit& u) {
  return std::string(kanexpr::units::text_of(u).view());
}

struct random_states {
  std::mt19937_64 source{11};
  double t = 0;
  VectorXd q, u, x, p, r;

  void draw() {
    t = random_numbers(source, 1, 2)(0);
    q = random_numbers(source, 3, 3), u = random_numbers(source, 3, 2);
    p = VectorXd::Constant(7, 1) + random_numbers(source, 7, 0.5);
    p(5) *= 9.81;
    x.resize(6);
    x << q, u;
  }
};

void expect_least_constraint(bool by_lagrange, bool has_linear) {
  SCOPED_TRACE(std::string(by_lagrange ? "Lagrange" : "Kane") + (has_linear ? ", with a linear one" : ""));
  model m = derive(pendulums_on_cart(by_lagrange, has_linear));
  ASSERT_EQ(m.mistake(), "");
  auto udot = m.function(m.udot()), lambda = m.function(m.multipliers()),
       jacobian = m.function(m.constraint_jacobian()), bias = m.function(m.get(quantity::constraint_bias)),
       left = m.function(m.velocity_residual()), full = m.function(m.get(quantity::mass_matrix_full)),
       right = m.function(m.get(quantity::forcing_full));
  ASSERT_EQ(m.mistake(), "");
  random_states at;
  for (int state = 0; state < 200; ++state) {
    at.draw();
    const by_hand expected{at.p, has_linear};
    const VectorXd found = udot(at.t, at.x, at.p, at.r), wanted = expected.accelerations(at.t, at.q, at.u);
    ASSERT_TRUE(udot.status());
    EXPECT_LE((found - wanted).norm(), 1e-12 * wanted.norm());
    const MatrixXd j = expected.jacobian(at.t, at.q, at.u);
    const VectorXd gamma = expected.bias(at.t, at.q, at.u);
    EXPECT_LE((jacobian(at.t, at.x, at.p, at.r) - j).norm(), 1e-14 * j.norm());
    EXPECT_LE((bias(at.t, at.x, at.p, at.r) - gamma).norm(), 1e-13 * (gamma.norm() + j.norm()));
    EXPECT_LE((left(at.t, at.x, at.p, at.r) - expected.residual(at.t, at.q, at.u).real()).norm(),
              1e-14 * (1 + j.norm() * at.u.norm()));
    // Chetaev's condition: the forces of the constraints act along ∂φ/∂u
    const VectorXd forces = j.transpose() * lambda(at.t, at.x, at.p, at.r),
                   inertia = expected.mass(at.q) * found - expected.force(at.q, at.u);
    EXPECT_LE((forces - inertia).norm(), 1e-12 * (inertia.norm() + expected.force(at.q, at.u).norm()));
    const VectorXd rates =
        full(at.t, at.x, at.p, at.r).partialPivLu().solve(VectorXd(right(at.t, at.x, at.p, at.r)));
    EXPECT_LE((rates.tail(3) - found).norm(), 1e-12 * found.norm());
  }
}

TEST(nonlinear_constraints, agree_with_the_principle_of_least_constraint) {
  for (const bool by_lagrange : {false, true})
    for (const bool has_linear : {false, true}) expect_least_constraint(by_lagrange, has_linear);
}

// The dependent speeds of a state by Newton's method in complex numbers.
Eigen::VectorXcd on_constraints(const by_hand& of, double t, Eigen::VectorXcd x,
                                const std::vector<Index>& dependent) {
  for (int steps = 0; steps < 60; ++steps) {
    Eigen::MatrixXcd slope(of.rows(), of.rows());
    for (Index i = 0; i < of.rows(); ++i) { // exact, because the constraints are quadratic in the speeds
      Eigen::VectorXcd ahead = x.tail(3), back = ahead;
      ahead(dependent[static_cast<std::size_t>(i)] - 3) += 1,
          back(dependent[static_cast<std::size_t>(i)] - 3) -= 1;
      slope.col(i) = (of.residual(t, x.head(3), ahead) - of.residual(t, x.head(3), back)) / 2.0;
    }
    const Eigen::VectorXcd left = of.residual(t, x.head(3), x.tail(3));
    Eigen::VectorXcd change = left / slope(0, 0);
    if (of.rows() == 2) { // Cramer's rule
      change(0) = slope(1, 1) * left(0) - slope(0, 1) * left(1);
      change(1) = slope(0, 0) * left(1) - slope(1, 0) * left(0);
      change /= slope(0, 0) * slope(1, 1) - slope(0, 1) * slope(1, 0);
    }
    for (Index i = 0; i < of.rows(); ++i) x(dependent[static_cast<std::size_t>(i)]) -= change(i);
  }
  return x;
}

// A along the constraints, compared with complex steps of the rates; the dependent speeds follow.
void expect_linearization(bool by_lagrange, bool has_linear) {
  SCOPED_TRACE(std::string(by_lagrange ? "Lagrange" : "Kane") + (has_linear ? ", with a linear one" : ""));
  model m = derive(pendulums_on_cart(by_lagrange, has_linear));
  auto rhs = m.function<complex>(m.rhs());
  auto matrix = m.function(m.get(quantity::state_matrix)),
       implicit_mass = m.function(m.get(quantity::implicit_mass_matrix)),
       implicit_state = m.function(m.get(quantity::implicit_state_matrix));
  ASSERT_EQ(m.mistake(), "");
  std::vector<Index> dependent, independent;
  for (int i = 0; i < 6; ++i) (m.known()->dependent[i] ? dependent : independent).push_back(i);
  const auto states = static_cast<Index>(independent.size());
  random_states at;
  int compared = 0;
  for (int tried = 0; tried < 200 && compared < 40; ++tried) {
    at.draw();
    const by_hand of{at.p, has_linear};
    const Eigen::VectorXcd point = on_constraints(of, at.t, at.x, dependent);
    const VectorXd x = point.real();
    if (!(of.residual(at.t, x.head(3), x.tail(3)).norm() < 1e-13)) continue; // there is no such state
    MatrixXd by_steps(states, states);
    for (Index j = 0; j < states; ++j) {
      Eigen::VectorXcd moved = x;
      moved(independent[static_cast<std::size_t>(j)]) += complex(0, step);
      const Eigen::VectorXcd rates = rhs(at.t, on_constraints(of, at.t, moved, dependent), at.p, at.r);
      for (Index i = 0; i < states; ++i)
        by_steps(i, j) = rates(independent[static_cast<std::size_t>(i)]).imag() / step;
    }
    if (by_steps.norm() > 1e5) continue; // nearly singular
    ++compared;
    const MatrixXd found = matrix(at.t, x, at.p, at.r);
    EXPECT_LE((found - by_steps).norm(), 1e-11 * by_steps.norm());
    const MatrixXd all = implicit_mass(at.t, x, at.p, at.r)
                             .partialPivLu()
                             .solve(MatrixXd(implicit_state(at.t, x, at.p, at.r)));
    for (Index i = 0; i < states; ++i)
      EXPECT_LE((all.row(independent[static_cast<std::size_t>(i)]) - found.row(i)).norm(),
                1e-10 * found.norm());
  }
  EXPECT_EQ(compared, 40);
}

TEST(nonlinear_constraints, are_linearized_along_themselves) {
  for (const bool by_lagrange : {false, true})
    for (const bool has_linear : {false, true}) expect_linearization(by_lagrange, has_linear);
}

// The gradient and the Hessian of weighted rates, compared with complex steps of the rates and of the
// gradient.
TEST(nonlinear_constraints, have_second_derivatives) {
  for (const bool by_lagrange : {false, true}) {
    model m = derive(pendulums_on_cart(by_lagrange, true));
    auto hessian = m.function(m.get(quantity::weighted_hessian));
    auto gradient = m.function<complex>(m.get(quantity::weighted_gradient)),
         rhs = m.function<complex>(m.rhs());
    ASSERT_EQ(m.mistake(), "");
    random_states at;
    for (int state = 0; state < 20; ++state) {
      at.draw();
      const VectorXd w = random_numbers(at.source, 6, 1);
      const Eigen::VectorXcd weights = w;
      const MatrixXd found = hessian(at.t, at.x, at.p, at.r, w);
      MatrixXd by_steps(6, 6);
      VectorXd slopes(6);
      for (Index j = 0; j < 6; ++j) {
        Eigen::VectorXcd moved = at.x;
        moved(j) += complex(0, step);
        by_steps.col(j) = gradient(at.t, moved, at.p, at.r, weights).imag() / step;
        slopes(j) = (w.transpose() * rhs(at.t, moved, at.p, at.r).imag())(0) / step;
      }
      if (slopes.norm() > 1e4) continue; // nearly singular
      const Eigen::VectorXcd x = at.x;
      EXPECT_LE((gradient(at.t, x, at.p, at.r, weights).real() - slopes).norm(), 1e-11 * slopes.norm());
      EXPECT_LE((found - by_steps).norm(), 1e-11 * by_steps.norm());
    }
  }
}

// A particle of constant speed in a plane, which is pushed by a force with a lag behind its velocity and
// lifts a second one to the height s = x².
struct pushed_particles : builder {
  static constexpr double mass = 1.3, lifted = 0.7, weight = 5, time_constant = 0.4;
  expression x = coordinate("x"), y = coordinate("y"), s = coordinate("s"), u = speed("u"), v = speed("v"),
             w = speed("w"), c = parameter("c"), z = state_variable("z");

  pushed_particles() : builder("N") {
    const auto n = inertial_frame();
    kinematic_equation(dot(x) - u), kinematic_equation(dot(y) - v), kinematic_equation(dot(s) - w);
    const auto o = origin("O"), p = offset("P", o, along(n, x, y, 0));
    const auto q = offset("Q", o, along(n, 0, 0, s));
    particle("P", p, number(mass)), particle("Q", q, number(lifted));
    force(p, along(n, z, 2 * z, 0)), force(q, along(n, 0, 0, number(-weight)));
    dynamics(z, (u - z) / time_constant);
    velocity_constraint(u * u + v * v - c * c);
    configuration_constraint(s - x * x);
    dependent(v), dependent(s), dependent(w);
  }

  // The state that belongs to x, y, u and z for the speed c.
  static Eigen::VectorXcd state(const Eigen::Vector4cd& free, double c) {
    Eigen::VectorXcd all(7);
    all << free[0], free[1], free[0] * free[0], free[2], std::sqrt(c * c - free[2] * free[2]),
        2.0 * free[0] * free[2], free[3];
    return all;
  }
};

// State variables with a constraint that is not linear in the speeds and one of the configuration.
TEST(nonlinear_constraints, hold_with_state_variables) {
  using b = pushed_particles;
  model m = derive(b());
  ASSERT_EQ(m.mistake(), "");
  auto rhs = m.function(m.rhs());
  auto complex_rhs = m.function<complex>(m.rhs());
  auto matrix = m.function(m.get(quantity::state_matrix));
  const VectorXd p = VectorXd::Constant(1, 1.7), nothing(0);
  std::mt19937_64 source(6);
  for (int i = 0; i < 30; ++i) {
    const Eigen::Vector4d free = random_numbers(source, 4, 1.2);
    const VectorXd at = b::state(free, p[0]).real();
    MatrixXd kkt = MatrixXd::Zero(5, 5);
    VectorXd right(5);
    kkt.diagonal().head(3) << b::mass, b::mass, b::lifted;
    kkt(3, 0) = 2 * at[3], kkt(3, 1) = 2 * at[4], kkt(4, 0) = -2 * at[0], kkt(4, 2) = 1;
    kkt.topRightCorner(3, 2) = kkt.bottomLeftCorner(2, 3).transpose();
    right << at[6], 2 * at[6], -b::weight, 0, 2 * at[3] * at[3];
    const VectorXd expected = kkt.partialPivLu().solve(right), rates = rhs(at, p);
    EXPECT_LE((rates.segment(3, 3) - expected.head(3)).norm(), 1e-12 * (1 + expected.norm()));
    EXPECT_NEAR(rates[6], (at[3] - at[6]) / b::time_constant, 1e-13);

    const int rows[]{0, 1, 3, 6}; // x, y, u and z
    MatrixXd by_steps(4, 4);
    for (int j = 0; j < 4; ++j) {
      Eigen::Vector4cd moved = free;
      moved[j] += complex(0, step);
      const Eigen::VectorXcd found = complex_rhs(b::state(moved, p[0]), Eigen::VectorXcd(p));
      for (int k = 0; k < 4; ++k) by_steps(k, j) = found[rows[k]].imag() / step;
    }
    const MatrixXd found = matrix(at, p);
    ASSERT_EQ(found.rows(), 4);
    EXPECT_LE((found - by_steps).norm(), 1e-11 * (1 + by_steps.norm()));
  }
}

// A particle of constant speed c in space, with an auxiliary speed along x.
struct constant_speed : builder {
  expression x = coordinate("x"), y = coordinate("y"), u = speed("u"), v = speed("v"),
             e = auxiliary_speed("e"), m = parameter("m"), c = parameter("c"), push = input("F");
  kanexpr::runtime::frame_id n = inertial_frame();

  constant_speed() : builder("N") {
    kinematic_equation(dot(x) - u), kinematic_equation(dot(y) - v);
    const auto p = offset("P", origin("O"), along(n, x, y, 0));
    velocity_apart_from_position(p, n, along(n, u + e, v, 0));
    particle("P", p, m);
    force(p, along(n, push, 0, 0));
    velocity_constraint((u + e) * (u + e) + v * v - c * c);
    dependent(v);
  }
};

// F_e + F_e* + J_e λ + R = 0 with J_e = 2 u; the same equation as that of u, so R = 0.
TEST(nonlinear_constraints, contribute_to_noncontributing_forces) {
  model m = derive(constant_speed());
  ASSERT_EQ(m.mistake(), "");
  const Eigen::Vector4d x(0, 0, 1.2, 0.9);
  const Eigen::Vector2d p(2, 1.5);
  const Eigen::Vector<double, 1> r(4);
  const double along = 4 / 2.0 * 0.9 * 0.9 / (1.5 * 1.5); // u' without the component along the velocity
  EXPECT_NEAR(m.function(m.udot())(0, x, p, r)(0), along, 1e-15);
  const double lambda = m.function(m.multipliers())(0, x, p, r)(0);
  EXPECT_NEAR(2 * 1.2 * lambda, 2 * along - 4, 1e-14);
  EXPECT_NEAR(m.function(m.noncontributing_forces())(0, x, p, r)(0), 0, 1e-14);
}

// The scale of ∂φ/∂v is formed from all speeds of its unit, so it does not vanish with v.
TEST(nonlinear_constraints, report_a_dependent_speed_that_vanishes) {
  model m = derive(constant_speed());
  auto udot = m.function(m.udot());
  const Eigen::Vector2d p(2, 1.5);
  const Eigen::Vector<double, 1> r(4);
  for (const double v : {0.0, 1e-12, -1e-12}) {
    udot(0, Eigen::Vector4d(0, 0, 1.5, v), p, r);
    EXPECT_EQ(udot.status().cause(),
              "the constraints cannot be solved for the dependent speed v at this state");
  }
  udot(0, Eigen::Vector4d(0, 0, 1.5, 1e-6), p, r);
  EXPECT_TRUE(udot.status());
}

TEST(nonlinear_constraints, must_hold_at_operating_points) {
  model m = derive(constant_speed());
  const auto at = [&](double speed) {
    return m.linearize({{"x", 0}, {"y", 0}, {"u", 3}, {"v", speed}, {"m", 1}, {"c", 5}, {"F", 0}});
  };
  auto held = at(4), violated = at(4.5);
  EXPECT_TRUE(held);
  ASSERT_EQ(violated.failures().size(), 1u);
  EXPECT_EQ(violated.failures()[0],
            "the operating point does not satisfy velocity constraint 1: the residual is 4.25");
}

TEST(nonlinear_constraints, impose_no_dependent_speeds) {
  model m = derive(constant_speed());
  const auto& v = m.mechanism().speeds[1];
  EXPECT_EQ(kanexpr::symbolic::print(m.imposed(v)), "v");
  EXPECT_EQ(kanexpr::symbolic::print(m.dependent_speeds()), "[v - (u^2 - c^2 + v^2)/(2*v)]");
}

// Velocities that are perpendicular to each other: the direction depends on the speeds.
TEST(nonlinear_constraints, may_have_directions_that_depend_on_speeds) {
  struct two_particles : builder {
    expression x = coordinate("x"), y = coordinate("y"), z = coordinate("z"), u = speed("u"), v = speed("v"),
               w = speed("w"), m = parameter("m");
    two_particles() : builder("N") {
      kinematic_equation(dot(x) - u), kinematic_equation(dot(y) - v), kinematic_equation(dot(z) - w);
      const auto n = inertial_frame();
      const auto o = origin("O"), p = offset("P", o, along(n, x, y, 0)),
                 q = offset("Q", p, along(n, 0, 0, z));
      particle("P", p, m), particle("Q", q, m);
      kanexpr::mechanics::known_motion known(mechanism());
      const auto of_q = kanexpr::mechanics::velocity_of_point(known.moving(), place(q));
      velocity_constraint(of_q, along(n, v, 2 * u, w));
    }
  };
  model m = derive(two_particles());
  ASSERT_EQ(m.mistake(), "");
  EXPECT_EQ(kanexpr::symbolic::print(m.velocity_residual()), "[3*u*v + w^2]");
  const Eigen::Matrix<double, 6, 1> x{0, 0, 0, 1, 2, 3};
  EXPECT_EQ((m.function(m.constraint_jacobian())(x, Eigen::Vector<double, 1>(1.0))),
            Eigen::RowVector3d(6, 3, 6));
  EXPECT_EQ(m.function(m.get(quantity::constraint_bias))(x, Eigen::Vector<double, 1>(1.0))(0), 0);
}

TEST(nonlinear_constraints, have_units) {
  using namespace kanexpr::units::si;
  struct with_units : builder {
    expression x = coordinate("x", meter), y = coordinate("y", meter), u = speed("u"), v = speed("v"),
               m = parameter("m", kilogram), c = parameter("c");
    explicit with_units(bool is_squared) : builder("N") {
      kinematic_equation(dot(x) - u), kinematic_equation(dot(y) - v);
      const auto n = inertial_frame();
      particle("P", offset("P", origin("O"), along(n, x, y, 0)), m);
      const expression of_u = u * u, of_v = v * v; // in this order
      velocity_constraint(of_u + of_v - (is_squared ? c * c : c + v));
    }
  };
  const with_units b(true);
  EXPECT_EQ(std::string(b.check().view()), "");
  EXPECT_EQ(text(b.units().of("c")), "m/s");
  model m = derive(b);
  EXPECT_EQ(text(m.unit_of(quantity::constraint_jacobian, 0, 0)), "m/s");
  EXPECT_EQ(text(m.unit_of(quantity::multipliers)), "N s/m");
  EXPECT_EQ(std::string(with_units(false).check().view()),
            "a velocity constraint equates u^2 + v^2 [m^2/s^2] and v + c [m/s]");
}

} // namespace
