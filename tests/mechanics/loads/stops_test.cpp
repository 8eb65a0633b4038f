// builds: clang++
// Stops: their force and its derivatives, and the energy along random motions.
#include <Eigen/Core>
#include <gtest/gtest.h>
#include <kanexpr/runtime/builder.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace {

namespace mechanics = kanexpr::mechanics;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using kanexpr::runtime::builder;
using kanexpr::symbolic::expression;
using kanexpr::symbolic::matrix;
using mechanics::quantity;

const VectorXd nothing(0);

// A body that slides between two stops at −1 and 2.
struct slider : builder {
  expression q = coordinate("q"), u = speed("u");

  explicit slider(double damping = 0.4, double width = 0.05) : builder("N") {
    kinematic_equation(dot(q) - u);
    const auto n = inertial_frame();
    particle("body", offset("P", origin("O"), along(n, q, 0, 0)), number(1));
    stop(given_length(q), number(-1), number(2), number(300), number(damping), number(width));
  }
};

struct stop_force {
  slider b;
  kanexpr::model model = kanexpr::derive(b);
  kanexpr::runtime::interpreted<double> acceleration = model.function(model.get(quantity::udot));
  double operator()(double q, double u) { return acceleration(Eigen::Vector2d(q, u))(0); }
};

TEST(stops, have_no_force_at_a_distance_and_never_pull) {
  stop_force force{slider(0.4)};
  for (double q = -1; q <= 2; q += 0.125)
    for (const double u : {-5.0, 0.0, 5.0}) EXPECT_EQ(force(q, u), 0);
  for (const double q : {2.01, 2.05, 2.4})
    for (double u = -30; u <= 30; u += 0.5) EXPECT_LE(force(q, u), 0);
  for (const double q : {-1.01, -1.05, -1.4})
    for (double u = -30; u <= 30; u += 0.5) EXPECT_GE(force(q, u), 0);
}

TEST(stops, follow_hunt_and_crossley_beyond_the_width) {
  stop_force force{slider(0.4)};
  EXPECT_NEAR(force(2.5, 0), -300 * (0.5 - 0.025), 1e-12);
  EXPECT_NEAR(force(2.5, 0.7), -300 * (0.5 - 0.025) * (1 + 0.4 * 0.7), 1e-12);
  EXPECT_NEAR(force(-1.5, 0.7), 300 * (0.5 - 0.025) * (1 - 0.4 * 0.7), 1e-12);
  EXPECT_EQ(force(2.5, -1.5 / 0.4), 0);
}

// The second derivative of the force is continuous: at the ends of the width, one-sided differences agree.
TEST(stops, are_twice_differentiable) {
  stop_force force{slider(0.4)};
  const double h = 1e-4;
  for (const double q : {2.0, 2.05, -1.0, -1.05})
    for (const double u : {0.0, 0.5}) {
      const double right = force(q + 2 * h, u) - 2 * force(q + h, u) + force(q, u);
      const double left = force(q - 2 * h, u) - 2 * force(q - h, u) + force(q, u);
      EXPECT_NEAR(right / (h * h), left / (h * h), 12 * 2 * 300 * h / (0.05 * 0.05));
      EXPECT_NEAR(force(q + h, u) - 2 * force(q, u) + force(q - h, u), 0,
                  300 * 6 * h * h * h / (0.05 * 0.05) + 1e-12);
    }
}

// The power of the force and the rate of the potential energy add up to what is lost; nothing is created.
TEST(stops, create_no_energy_at_any_state) {
  slider b;
  auto model = kanexpr::derive(b);
  auto acceleration = model.function(model.get(quantity::udot));
  slider conservative(0.0);
  auto elastic_model = kanexpr::derive(conservative);
  auto elastic = elastic_model.function(elastic_model.get(quantity::udot));
  std::mt19937_64 source(3);
  std::uniform_real_distribution<double> place(-2, 3), logarithm(-9, 3);
  std::bernoulli_distribution is_negative;
  for (int i = 0; i < 20000; ++i) {
    const double speed = std::pow(10.0, logarithm(source)) * (is_negative(source) ? -1 : 1);
    const Eigen::Vector2d x(place(source), speed);
    const double whole = acceleration(x)(0), stored = elastic(x)(0);
    EXPECT_LE((whole - stored) * speed, 0) << x.transpose();
  }
}

// Random motions: the body is thrown against the stops by a method of Runge and Kutta with small steps.
TEST(stops, create_no_energy_along_random_motions) {
  slider b;
  auto model = kanexpr::derive(b);
  matrix result(b.graph(), 2, 1);
  result.entries[0] =
      model.get(quantity::kinetic_energy).entries[0] + model.get(quantity::potential_energy).entries[0];
  result.entries[1] = model.get(quantity::udot).entries[0];
  auto values = model.function(result);
  std::mt19937_64 source(9);
  std::uniform_real_distribution<double> place(-1, 2), speed(2, 4);
  for (int motion = 0; motion < 4; ++motion) {
    Eigen::Vector2d x(place(source), speed(source));
    const double start = values(x)(0), h = 4e-5;
    double least = start;
    const auto rate = [&](const Eigen::Vector2d& at) { return Eigen::Vector2d(at(1), values(at)(1)); };
    for (int i = 0; i < 50000; ++i) {
      const Eigen::Vector2d k1 = rate(x), k2 = rate(x + h / 2 * k1), k3 = rate(x + h / 2 * k2),
                            k4 = rate(x + h * k3);
      x += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
      const double energy = values(x)(0);
      EXPECT_LT(energy, least + 1e-9 * start);
      least = (std::min)(least, energy);
    }
    EXPECT_LT(least, 0.999 * start);
  }
}

TEST(stops, conserve_energy_without_damping) {
  slider b(0.0);
  auto model = kanexpr::derive(b);
  auto acceleration = model.function(model.get(quantity::udot)),
       energy = model.function(model.get(quantity::potential_energy));
  for (const double q : {-1.3, -1.02, 0.4, 2.03, 2.6}) {
    const double h = 1e-5, rise = energy(Eigen::Vector2d(q + h, 0))(0) - energy(Eigen::Vector2d(q - h, 0))(0);
    EXPECT_NEAR(acceleration(Eigen::Vector2d(q, 3))(0), -rise / (2 * h), 1e-5);
  }
}

} // namespace
