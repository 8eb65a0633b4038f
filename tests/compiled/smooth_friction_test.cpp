// builds: clang++
// The friction c tanh(u / v), evaluated by every method of evaluating functions of a model.
#include <kanexpr/batch.hpp>
#include <kanexpr/symbolic.hpp>

#include "exporting/curved.hpp"
#include "models/simple_pendulum.hpp"

#include <unsupported/Eigen/AutoDiff>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

namespace {

using namespace simple_pendulum;

constexpr parameter<"c"> c; // the largest torque of the friction
constexpr parameter<"v"> v;

struct Rubbed
    : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, parameters<m, l, g, c, v>,
                  bodies<Bob>, loads<gravity<g * N::x>, torque<A, -c * tanh(u / v) * N::z>>> {};

using eom = equations_of_motion<Rubbed>;

constexpr double mass = 1.5, length = 0.8, weight = 9.81, friction = 0.3, slow = 0.2;
const eom::parameters parameters{{m, mass}, {l, length}, {g, weight}, {c, friction}, {v, slow}};

template <class T>
T acceleration(const T& angle, const T& speed) {
  using std::sin, std::tanh;
  return -T(weight / length) * sin(angle) - T(friction / (mass * length * length)) * tanh(speed / T(slow));
}

template <class T>
T compiled(const T& angle, const T& speed) {
  kanexpr::state<Rubbed, T> x;
  x[q] = angle;
  x[u] = speed;
  const kanexpr::parameter_values<Rubbed, T> p(parameters.cast<T>());
  return eom::udot(x, p)(0);
}

TEST(smooth_friction, is_that_of_every_scalar_type) {
  for (const double speed : {-3.0, -0.1, 0.0, 1e-9, 0.05, 0.4, 30.0}) {
    EXPECT_NEAR(compiled(0.4, speed), acceleration(0.4, speed), 1e-14);
    EXPECT_NEAR(compiled(0.4F, static_cast<float>(speed)), acceleration(0.4, speed), 1e-5);
    EXPECT_NEAR(static_cast<double>(compiled(0.4L, static_cast<long double>(speed))),
                static_cast<double>(acceleration(0.4L, static_cast<long double>(speed))), 1e-14);
    const std::complex<double> imaginary(speed, 1e-3);
    EXPECT_LT(
        std::abs(compiled({0.4, 0.1}, imaginary) - acceleration(std::complex<double>(0.4, 0.1), imaginary)),
        1e-14);
    using number = Eigen::AutoDiffScalar<Eigen::Vector2d>;
    const Eigen::Vector2d slope = compiled(number(0.4, 2, 0), number(speed, 2, 1)).derivatives();
    const double cosh = std::cosh(speed / slow);
    EXPECT_NEAR(slope(1), -friction / (mass * length * length * slow * cosh * cosh), 1e-13);
  }
}

TEST(smooth_friction, is_a_constant_where_all_is) {
  constexpr auto udot = eom::udot.constant({0.4, 0.05}, {mass, length, weight, friction, slow});
  EXPECT_NEAR(udot(0), acceleration(0.4, 0.05), 1e-14);
}

TEST(smooth_friction, is_linearized_and_printed) {
  const auto [A, B] = linearization<Rubbed>::explicit_form(eom::state{{q, 0.4}, {u, 0.05}}, parameters);
  const double cosh = std::cosh(0.05 / slow);
  EXPECT_NEAR(A(1, 1), -friction / (mass * length * length * slow * cosh * cosh), 1e-13);
  EXPECT_EQ(print(derive<Rubbed>().forcing()), "[-c*tanh(u/v) - g*l*m*sin(q)]");
}

/// Functions that <complex> lacks, evaluated by every method of evaluating functions of a model.
template <class T>
T acceleration_of_the_curved(T q, T u, T input) {
  const T pi = std::numbers::pi_v<T>, r = std::remainder(3 * q - input, 2 * pi);
  return (-2 * std::cbrt(q - 1) - std::erf(u / T(0.5)) + (r < pi ? r : -pi) + std::atan2(input, q) +
          static_cast<T>((u > 0) - (u < 0)) * std::abs(q)) /
         T(0.75);
}

template <class T>
T udot_of_the_curved(T angle, T speed, T torque) {
  kanexpr::state<curved::System, T> x;
  x[curved::q] = angle;
  x[curved::u] = speed;
  const kanexpr::parameter_values<curved::System> p(3, 0.5, 2, 0.5);
  kanexpr::input_values<curved::System, T> r;
  r[curved::T] = torque;
  return kanexpr::equations_of_motion<curved::System>::udot(x, p, r)(0);
}

const std::array<std::array<double, 3>, 6> curved_points{
    {{0.4, 1.2, 0.7}, {-2, -0.3, 5}, {1.7, 0.01, -9}, {30, 0.2, 1}, {1, 0.6, 3.1}, {-0.2, -3, -40}}};

TEST(functions_without_complex_values, are_those_of_every_scalar_type) {
  typedef double pack __attribute__((vector_size(16)));
  for (const auto& [angle, speed, torque] : curved_points) {
    const double expected = acceleration_of_the_curved(angle, speed, torque);
    EXPECT_NEAR(udot_of_the_curved(angle, speed, torque), expected, 1e-14 * (1 + std::abs(expected)));
    EXPECT_NEAR(udot_of_the_curved<float>(static_cast<float>(angle), static_cast<float>(speed),
                                          static_cast<float>(torque)),
                expected, 1e-4);
    EXPECT_NEAR(static_cast<double>(udot_of_the_curved<long double>(angle, speed, torque)),
                static_cast<double>(acceleration_of_the_curved<long double>(angle, speed, torque)), 1e-14);
    const pack side_by_side = udot_of_the_curved(pack{1, angle}, pack{3, speed}, pack{torque, torque});
    EXPECT_EQ(side_by_side[0], udot_of_the_curved(1.0, 3.0, torque));
    EXPECT_EQ(side_by_side[1], udot_of_the_curved(angle, speed, torque));
  }
}

TEST(functions_without_complex_values, are_linearized_as_by_complex_steps_and_differences) {
  using curved::System;
  using complex = std::complex<double>;
  const double step = 1e-30, h = 1e-6;
  for (const auto& [angle, speed, torque] : curved_points) {
    if (std::abs(angle - 1) < 0.1) continue; // the cube root is steep
    kanexpr::state<System> x;
    x << angle, speed;
    const auto [A, B] = kanexpr::linearization<System>::explicit_form(
        x, kanexpr::parameter_values<System>(3, 0.5, 2, 0.5), kanexpr::input_values<System>(torque));
    const complex re_q(angle), re_u(speed), re_T(torque), i(0, step);
    EXPECT_NEAR(A(1, 0), udot_of_the_curved(re_q + i, re_u, re_T).imag() / step, 1e-13);
    EXPECT_NEAR(A(1, 1), udot_of_the_curved(re_q, re_u + i, re_T).imag() / step, 1e-13);
    EXPECT_NEAR(B(1, 0), udot_of_the_curved(re_q, re_u, re_T + i).imag() / step, 1e-13);
    EXPECT_NEAR(
        A(1, 0),
        (udot_of_the_curved(angle + h, speed, torque) - udot_of_the_curved(angle - h, speed, torque)) /
            (2 * h),
        1e-6);
    EXPECT_NEAR(
        B(1, 0),
        (udot_of_the_curved(angle, speed, torque + h) - udot_of_the_curved(angle, speed, torque - h)) /
            (2 * h),
        1e-6);
  }
}

TEST(functions_without_complex_values, have_an_infinite_slope_where_a_cube_root_is_steep) {
  kanexpr::state<curved::System> x;
  x << 1, 1.2;
  const auto [A, B] = kanexpr::linearization<curved::System>::explicit_form(
      x, kanexpr::parameter_values<curved::System>(3, 0.5, 2, 0.5),
      kanexpr::input_values<curved::System>(0.7));
  EXPECT_EQ(A(1, 0), -std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isfinite(A(1, 1)) && std::isfinite(B(1, 0)));
}

TEST(functions_without_complex_values, are_constants_where_all_is) {
  constexpr auto udot =
      kanexpr::equations_of_motion<curved::System>::udot.constant({0.4, 1.2}, {3, 0.5, 2, 0.5}, {0.7});
  EXPECT_NEAR(udot(0), acceleration_of_the_curved(0.4, 1.2, 0.7), 1e-14);
}

} // namespace
