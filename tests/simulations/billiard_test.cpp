// builds: clang++
// A billiard shot from sliding to rolling, compared with its closed form.
#include <kanexpr/simulate.hpp>

#include <Eigen/Core>
#include <models/billiard_ball.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace billiard_ball;

constexpr auto along_x = dot(slip, Table::x), along_y = dot(slip, Table::y);
constexpr auto forward = dot(velocity_of<Ball>, Table::x), sideward = dot(velocity_of<Ball>, Table::y);

/// With friction μ m g v/√(v² + vₛ²), the slip v of a homogeneous ball keeps its direction, and its rate is
/// −(7/2) μ g v/√(v² + vₛ²). Its integral, √(v² + vₛ²) − vₛ arsinh(vₛ/v), therefore falls at a constant rate.
/// For vₛ = 0, the sliding ends at 2 v/(7 μ g).
double integral_of(double slip_speed, double smoothing) {
  return std::hypot(slip_speed, smoothing) - smoothing * std::asinh(smoothing / slip_speed);
}

TEST(billiard, a_ball_slides_as_in_closed_form_and_then_rolls) {
  const double mass = 0.17, radius = 0.03, weight = mass * 9.81, stiffness = 1e7, smoothing = 1e-3;
  const double sunk = std::pow(weight / stiffness, 2.0 / 3), rate = 3.5 * 0.2 * 9.81;
  state<System> x{};
  x[q_of<Ball, 3>] = radius - sunk, x[q_of<Ball, 7>] = 1;
  x[u_of<Ball, 1>] = 1.5, x[u_of<Ball, 4>] = -40, x[u_of<Ball, 5>] = -60, x[u_of<Ball, 6>] = 20;
  const auto run = simulate<System>(
      x, {{m, mass}, {r, radius}, {g, 9.81}, {mu, 0.2}, {s, smoothing}, {k, stiffness}, {d, sunk / 4}},
      {0, 0.8}, {.relative_tolerance = 1e-11, .absolute_tolerance = 1e-13, .output_every = 0.05});
  ASSERT_TRUE(run) << run.cause();
  const Eigen::Vector2d first(1.5 + 60 * radius, -40 * radius);
  const auto slips_x = run.trajectory.along<along_x>(), slips_y = run.trajectory.along<along_y>();
  const double end = 2 * first.norm() / (7 * 0.2 * 9.81);
  EXPECT_NEAR(end, 0.51, 0.01);
  for (std::size_t i = 0; i < slips_x.size(); ++i) {
    const Eigen::Vector2d now(slips_x[i], slips_y[i]);
    const double t = run.trajectory[i].t;
    if (t > end) {
      EXPECT_LT(now.norm(), 3 * smoothing * std::exp(rate * (end - t) / smoothing) + 1e-9) << t;
      continue;
    }
    EXPECT_NEAR(integral_of(now.norm(), smoothing), integral_of(first.norm(), smoothing) - rate * t, 1e-8)
        << t;
    EXPECT_NEAR(now.normalized().dot(first.normalized()), 1, 1e-9) << t;
  }
  const Eigen::Vector2d rolling = Eigen::Vector2d(1.5, 0) - 2 * first / 7;
  EXPECT_NEAR(run.trajectory.along<forward>().back(), rolling(0), 1e-8);
  EXPECT_NEAR(run.trajectory.along<sideward>().back(), rolling(1), 1e-8);
}

} // namespace
