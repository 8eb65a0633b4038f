// builds: clang++ sanitize no-exceptions
#include "no_heap.hpp"

#include <gtest/gtest.h>
#include <kanexpr/numeric/newton.hpp>

#include <limits>
#include <vector>

namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using kanexpr::numeric::newton;
using kanexpr::numeric::newton_options;
using kanexpr::numeric::newton_report;
using number = Eigen::Matrix<double, 1, 1>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// A circle and a hyperbola, which meet where x0 ± x1 = √(4 ± 2).
Vector2d circle_and_hyperbola(const Vector2d& x) { return {x.squaredNorm() - 4, x(0) * x(1) - 1}; }
Matrix2d their_slope(const Vector2d& x) {
  Matrix2d j;
  j << 2 * x(0), 2 * x(1), x(1), x(0);
  return j;
}
const Vector2d meeting((std::sqrt(6.0) + std::sqrt(2.0)) / 2, (std::sqrt(6.0) - std::sqrt(2.0)) / 2);

// A scalar function and its slope.
template <class F, class D>
newton_report solve(double& x, F f, D slope, const newton_options& options = {}) {
  number at(x);
  const newton_report report = newton(
      at, [&](const number& v) { return number(f(v(0))); },
      [&](const number& v) { return number(slope(v(0))); }, options);
  x = at(0);
  return report;
}

TEST(newton, solves_to_rounding) {
  Vector2d x(3, 0.2);
  const newton_report report = newton(x, circle_and_hyperbola, their_slope);
  EXPECT_TRUE(report.converged);
  EXPECT_FALSE(report.singular);
  EXPECT_LE(report.residual, 1e-15);
  EXPECT_LE((x - meeting).norm(), 1e-15);
}

// Each error is of the order of the square of the previous one.
TEST(newton, converges_quadratically) {
  std::vector<double> errors;
  for (int steps = 0; steps < 5; ++steps) {
    Vector2d x(2.1, 0.4);
    newton_options options;
    options.most_steps = steps;
    EXPECT_EQ(newton(x, circle_and_hyperbola, their_slope, options).steps, steps);
    errors.push_back((x - meeting).norm());
  }
  EXPECT_GT(errors[0], 0.1);
  for (std::size_t i = 1; i < errors.size(); ++i)
    EXPECT_LE(errors[i], errors[i - 1] * errors[i - 1] + 1e-15) << "step " << i;
}

TEST(newton, shortens_steps_that_lead_away) {
  const auto slope = [](double v) { return 1 / (1 + v * v); };
  double plain = 3;
  for (int i = 0; i < 4; ++i) plain -= std::atan(plain) / slope(plain);
  EXPECT_GT(std::abs(plain), 1e3); // full steps diverge
  double x = 3;
  const newton_report report = solve(x, [](double v) { return std::atan(v); }, slope);
  EXPECT_TRUE(report.converged);
  EXPECT_LE(std::abs(x), 1e-15);
}

TEST(newton, shortens_steps_to_where_the_function_is_not_defined) {
  double x = 5; // a full step leads to a negative number
  EXPECT_LT(x - x * std::log(x), 0);
  EXPECT_TRUE(solve(x, [](double v) { return std::log(v); }, [](double v) { return 1 / v; }).converged);
  EXPECT_NEAR(x, 1, 1e-15);
}

TEST(newton, tells_where_the_slope_is_singular) {
  double x = 0; // at the bottom of a parabola, above and below zero
  for (const double bottom : {1.0, -1.0}) {
    const newton_report report =
        solve(x, [&](double v) { return v * v + bottom; }, [](double v) { return 2 * v; });
    EXPECT_FALSE(report.converged);
    EXPECT_TRUE(report.singular);
    EXPECT_EQ(report.residual, 1);
    EXPECT_EQ(x, 0);
  }
}

TEST(newton, leaves_a_singular_start_if_there_is_a_way) {
  Vector2d x(0, 0);
  const newton_report report = newton(
      x, [](const Vector2d& v) { return Vector2d(v(0) * v(0) + v(1) - 1, v(0) * v(1)); },
      [](const Vector2d& v) {
        Matrix2d j;
        j << 2 * v(0), 1, v(1), v(0);
        return j;
      });
  EXPECT_TRUE(report.converged);
  EXPECT_FALSE(report.singular);
  EXPECT_LE((x - Vector2d(0, 1)).norm(), 1e-15);
}

TEST(newton, ends_where_there_is_no_solution) {
  double x = 3;
  const newton_report report = solve(x, [](double v) { return v * v + 1; }, [](double v) { return 2 * v; });
  EXPECT_FALSE(report.converged);
  EXPECT_GE(report.residual, 1);
  EXPECT_LE(report.residual, 10);
}

TEST(newton, takes_no_more_steps_than_allowed) {
  double x = 1e6;
  newton_options options;
  options.most_steps = 3;
  const newton_report report =
      solve(x, [](double v) { return v * v - 1; }, [](double v) { return 2 * v; }, options);
  EXPECT_FALSE(report.converged);
  EXPECT_EQ(report.steps, 3);
}

TEST(newton, does_not_take_what_is_no_number_for_a_solution) {
  for (const Vector2d& value : {Vector2d(nan, nan), Vector2d(0, nan), Vector2d(nan, 0)}) {
    Vector2d x(1, 2);
    const newton_report report = newton(
        x, [&](const Vector2d&) { return value; },
        [](const Vector2d&) { return Matrix2d(Matrix2d::Identity()); });
    EXPECT_FALSE(report.converged);
    EXPECT_NE(report.residual, 0);
    EXPECT_EQ(report.steps, 0);
    EXPECT_EQ(x, Vector2d(1, 2));
  }
  double x = 2;
  EXPECT_FALSE(solve(x, [](double v) { return v; }, [](double) { return nan; }).converged);
  EXPECT_EQ(x, 2);
}

TEST(newton, takes_no_step_from_a_solution) {
  double x = 1;
  const newton_report report = solve(x, [](double v) { return v - 1; }, [](double) { return nan; });
  EXPECT_TRUE(report.converged);
  EXPECT_EQ(report.steps, 0);
  EXPECT_EQ(report.residual, 0);
}

TEST(newton, takes_no_memory_for_fixed_sizes) {
  Vector2d x(3, 0.2);
  {
    no_heap::guard guard;
    newton(x, circle_and_hyperbola, their_slope);
  }
  EXPECT_LE((x - meeting).norm(), 1e-15);
  Vector2d stuck(0, 0); // by least squares
  no_heap::guard guard;
  newton(stuck, circle_and_hyperbola, their_slope);
}

TEST(newton, has_nothing_to_do_without_unknowns) {
  Eigen::VectorXd none(0);
  const newton_report report = newton(
      none, [](const Eigen::VectorXd& v) { return v; },
      [](const Eigen::VectorXd&) { return Eigen::MatrixXd(0, 0); });
  EXPECT_TRUE(report.converged);
  EXPECT_EQ(report.steps, 0);
}

TEST(newton, takes_vectors_of_any_size) {
  Eigen::VectorXd x(2);
  x << 3, 0.2;
  const newton_report report = newton(
      x, [](const Eigen::VectorXd& v) { return Eigen::VectorXd(circle_and_hyperbola(v)); },
      [](const Eigen::VectorXd& v) { return Eigen::MatrixXd(their_slope(v)); });
  EXPECT_TRUE(report.converged);
  EXPECT_LE((x - meeting).norm(), 1e-15);
}

} // namespace
