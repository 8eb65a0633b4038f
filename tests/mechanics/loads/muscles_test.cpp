// builds: clang++ all
// Muscles with tendons: the balance of their fibers, their formulations against each other, their equilibria
// and the limit of a rigid tendon. Their power and derivatives are in elements_test.cpp, and SymPy's
// references in sympy_actuators_test.cpp.
#include <Eigen/Core>
#include <gtest/gtest.h>
#include <kanexpr/lower/complex_math.hpp>
#include <kanexpr/mechanics/loads/muscle.hpp>
#include <kanexpr/numeric/muscle_curves.hpp>
#include <kanexpr/runtime/builder.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <random>
#include <string>

namespace {

namespace curves = kanexpr::numeric::muscle_curves;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using kanexpr::muscle_formulation;
using kanexpr::muscle_parameters;
using kanexpr::mechanics::quantity;
using kanexpr::runtime::builder;
using kanexpr::runtime::muscle_data;
using kanexpr::runtime::pathway;
using kanexpr::runtime::point_id;
using kanexpr::symbolic::expression;
using kanexpr::symbolic::matrix;

class random_numbers {
public:
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(from_); }

private:
  std::mt19937_64 from_{32};
};

// A particle at the distance q from the origin of a muscle, whose rate is u.
struct pulled : builder {
  expression q = coordinate("q"), u{};
  point_id o = origin("O"), p{};
  expression e{};

  explicit pulled(bool by_lagrange = false) : builder("N") {
    if (by_lagrange)
      rates_as_speeds();
    else
      u = speed("u"), kinematic_equation(dot(q) - u);
    p = offset("P", o, along(inertial_frame(), q, 0, 0));
    particle("Bob", p, number(1));
    e = input("e");
  }
};

muscle_data some_muscle(muscle_formulation formulation) {
  return {.peak_isometric_force = 700,
          .optimal_fiber_length = 0.11,
          .tendon_slack_length = 0.24,
          .maximal_fiber_velocity = 8,
          .pennation = 0.3,
          .fiber_damping = 0.07,
          .tendon_strain = 0.06,
          .passive_strain = 0.55,
          .has_activation_dynamics = false,
          .formulation = formulation};
}

// Returns v for the active force, the damping and the load.
struct balance : builder {
  matrix wanted;
  balance() : builder("N") {
    const expression q = coordinate("q"), u = speed("u"), active = parameter("A"), damping = parameter("B"),
                     load = parameter("F");
    kinematic_equation(dot(q) - u);
    particle("Bob", offset("P", origin("O"), along(inertial_frame(), q, 0, 0)), number(1));
    for (const expression& each : {active, damping, load}) used_elsewhere(each);
    wanted = matrix(graph(), 1, 1);
    wanted.entries[0] = kanexpr::mechanics::fiber_velocity(active, damping, load);
  }
};

TEST(muscles, fibers_balance_their_load) {
  balance b;
  auto model = kanexpr::derive(b);
  auto velocity = model.function(b.wanted);
  auto by_complex = model.function<std::complex<double>>(b.wanted);
  random_numbers source;
  for (int k = 0; k < 3000; ++k) {
    const double active = k % 7 == 0 ? 0 : std::pow(10, source.between(-6, 0.2)),
                 damping = std::pow(10, source.between(-7, 0.5)), sought = source.between(-1.5, 1.5),
                 load = active * curves::velocity_force(sought) + damping * sought;
    const VectorXd p = Eigen::Vector3d(active, damping, load);
    const double v = velocity(Eigen::Vector2d(0, 0), p)(0);
    const double slope = active * curves::velocity_scale * curves::velocity_factor /
                             std::hypot(curves::velocity_factor * v + curves::velocity_shift, 1) +
                         damping;
    const double found = active * curves::velocity_force(v) + damping * v;
    ASSERT_NEAR(found, load, 3e-14 * (active + damping + std::abs(load))) << active << ' ' << damping;
    Eigen::VectorXcd moved = p;
    moved(2) += std::complex<double>(0, 1e-30);
    const Eigen::VectorXcd z = by_complex(Eigen::Vector2cd(0, 0), moved);
    ASSERT_NEAR(z(0).imag() / 1e-30 * slope, 1, 1e-10) << active << ' ' << damping << ' ' << v;
  }
  // far beyond the range of the curves
  for (const double load : {-50.0, 300.0}) {
    const double v = velocity(Eigen::Vector2d(0, 0), Eigen::Vector3d(0.7, 0.05, load))(0);
    const double w = std::asinh(curves::velocity_factor * v + curves::velocity_shift);
    EXPECT_NEAR(0.7 * (curves::velocity_scale * w + curves::velocity_offset) + 0.05 * v, load,
                1e-13 * std::abs(load));
  }
}

// The rates of the state at a length, a rate and an activation.
template <class Model>
VectorXd rates_of(Model& rates, double length, double rate, double state, double activation) {
  return rates(Eigen::Vector3d(length, rate, state), VectorXd(0), VectorXd::Constant(1, activation));
}

auto rates_with(muscle_formulation formulation) {
  pulled b;
  b.muscle("M", b.straight(b.o, b.p), b.e, some_muscle(formulation));
  auto model = kanexpr::derive(b);
  return model.function(model.get(quantity::rhs));
}

TEST(muscles, formulations_agree) {
  auto of_force = rates_with(muscle_formulation::tendon_force),
       of_length = rates_with(muscle_formulation::fiber_length);
  random_numbers source;
  for (int k = 0; k < 200; ++k) {
    const double fiber = source.between(0.5, 1.5), strain = source.between(-0.01, 0.06),
                 projected = 0.11 * std::sqrt(fiber * fiber - std::pow(std::sin(0.3), 2)),
                 length = 0.24 * (1 + strain) + projected, rate = source.between(-1, 1),
                 activation = k % 5 == 0 ? 0 : source.between(0, 1),
                 force = curves::tendon_force(1 + strain, 0.06);
    const VectorXd by_its_force = rates_of(of_force, length, rate, force, activation),
                   by_its_length = rates_of(of_length, length, rate, fiber, activation);
    EXPECT_NEAR(by_its_force(1), by_its_length(1), 1e-11 * (std::abs(by_its_length(1)) + 700));
    const double fiber_rate = 0.11 * by_its_length(2), cosine = projected / (0.11 * fiber);
    const double expected =
        curves::tendon_factor(0.06) * (force + 0.25) * (rate - fiber_rate / cosine) / 0.24;
    EXPECT_NEAR(by_its_force(2), expected, 1e-11 * (1 + std::abs(expected))) << fiber << ' ' << strain;
  }
}

// Around a cylinder and with a moment arm; Kane's and Lagrange's methods, and the power of the tension.
TEST(muscles, act_along_every_pathway) {
  for (const bool with_arm : {false, true}) {
    const auto rates = [&](bool by_lagrange, const VectorXd& x) {
      pulled b(by_lagrange);
      const auto axis = b.along(b.inertial_frame(), 0, 0, 1);
      const point_id far = b.offset("F", b.p, b.along(b.inertial_frame(), 0, 0.4, 0)),
                     drum = b.offset("D", b.p, b.along(b.inertial_frame(), 0.1, 0.2, 0));
      const pathway path = with_arm ? b.given_length(0.3 + 0.05 * b.q * b.q)
                                    : b.around_cylinder(b.inertial_frame(), drum, axis, b.number(0.05), b.o,
                                                        far, kanexpr::wrapping::counterclockwise);
      b.muscle("M", path, b.e, some_muscle(muscle_formulation::tendon_force));
      auto model = kanexpr::derive(b);
      EXPECT_EQ(model.mistake(), "");
      return VectorXd(model.function(model.get(quantity::rhs))(x, VectorXd(0), VectorXd::Constant(1, 0.5)));
    };
    const VectorXd x = Eigen::Vector3d(0.2, 0.3, 0.4), kane = rates(false, x), lagrange = rates(true, x);
    EXPECT_LT((kane - lagrange).norm(), 1e-12 * kane.norm());
    if (with_arm) {
      EXPECT_NEAR(kane(1), -700 * 0.4 * 0.1 * 0.2, 1e-12);
    }
  }
}

TEST(muscles, rest_in_equilibrium) {
  auto of_force = rates_with(muscle_formulation::tendon_force),
       of_length = rates_with(muscle_formulation::fiber_length);
  constexpr muscle_parameters same{.peak_isometric_force = 700,
                                   .optimal_fiber_length = 0.11,
                                   .tendon_slack_length = 0.24,
                                   .pennation = 0.3,
                                   .tendon_strain = 0.06,
                                   .passive_strain = 0.55};
  random_numbers source;
  for (int k = 0; k < 50; ++k) {
    const double length = source.between(0.28, 0.42), activation = source.between(0, 1);
    const kanexpr::muscle_at_rest rest = kanexpr::muscle_equilibrium(same, length, activation);
    EXPECT_NEAR(rates_of(of_force, length, 0, rest.tendon_force, activation)(2), 0, 1e-9);
    EXPECT_NEAR(rates_of(of_length, length, 0, rest.fiber_length, activation)(2), 0, 1e-9);
  }
  EXPECT_TRUE(std::isnan(kanexpr::muscle_equilibrium(same, 0.23, 0.5).tendon_force));
  EXPECT_TRUE(std::isnan(kanexpr::muscle_equilibrium(same, 0.1, 0.5).fiber_length));
}

// The force at rest with a tendon that yields by ε tends to that with a rigid tendon, linearly in ε.
TEST(muscles, tendon_tends_to_a_rigid_one) {
  pulled b;
  b.muscle("M", b.straight(b.o, b.p), b.e, some_muscle(muscle_formulation::rigid_tendon));
  auto model = kanexpr::derive(b);
  const VectorXd rates = model.function(model.get(quantity::rhs))(Eigen::Vector2d(0.35, 0), VectorXd(0),
                                                                  VectorXd::Constant(1, 0.6));
  const auto difference = [&](double strain) {
    // the curve reaches the peak force at 1 + strain, and rises from 0.995 − 1.38 strain or so
    const muscle_parameters m{.peak_isometric_force = 700.0,
                              .optimal_fiber_length = 0.11,
                              .tendon_slack_length = 0.24 / 0.995,
                              .pennation = 0.3,
                              .tendon_strain = strain - 0.005,
                              .passive_strain = 0.55};
    return 700 * kanexpr::muscle_equilibrium(m, 0.35, 0.6).tendon_force + rates(1);
  };
  EXPECT_LT(std::abs(difference(1e-5)), 0.02);
  EXPECT_NEAR(difference(1e-4) / difference(1e-5), 10, 0.1);
}

std::string mistake_of(void (*is_made)(pulled&)) {
  pulled b;
  b.used_elsewhere(b.e);
  is_made(b);
  return std::string((b.check)().view());
}

TEST(muscles, report_mistakes) {
  EXPECT_EQ(mistake_of([](pulled& b) {
              muscle_data data = some_muscle(muscle_formulation::rigid_tendon);
              data.optimal_fiber_length = 0.0;
              b.muscle("M", b.straight(b.o, b.p), b.e, data);
            }),
            "the optimal fiber length of the muscle M is not positive");
  EXPECT_EQ(mistake_of([](pulled& b) {
              b.muscle("M", pathway(), b.e, some_muscle(muscle_formulation::rigid_tendon));
            }),
            "the muscle M acts along a pathway that has no points");
  EXPECT_EQ(mistake_of([](pulled& b) {
              for (int i = 0; i < 2; ++i)
                b.muscle("M", b.straight(b.o, b.p), b.e, some_muscle(muscle_formulation::tendon_force));
            }),
            "two muscles are called M");
  EXPECT_EQ(mistake_of([](pulled& b) {
              b.lag("L", b.e, 0.1);
              b.speed("v");
            }),
            "a speed is declared after state variable y_L; declare state variables after all speeds");
  EXPECT_EQ(mistake_of([](pulled& b) { b.lag("L", b.e, 1 / 2); }),
            "an argument of block L is 0, which is also the value of 1/2 in C++; write 0.5, or 0.0 if you "
            "mean zero");
  EXPECT_EQ(mistake_of([](pulled& b) { b.rotor("R", b.q, b.q); }),
            "the inertia or the gear ratio of rotor R changes; they may contain only numbers and parameters");
  EXPECT_EQ(mistake_of([](pulled& b) { b.delay("L", 21, b.e, 0.1); }),
            "expected an order of block L from 1 to 20, got 21");
  EXPECT_EQ(mistake_of([](pulled& b) { b.lag("L", pulled().e, 0.1); }),
            "block L contains an expression that belongs to a different mechanism or to none");
}

} // namespace
