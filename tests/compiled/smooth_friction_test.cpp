// Friction that is c tanh(u / v), in every way in which a function of a model is evaluated.
#include <kanexpr/symbolic.hpp>

#include "models/simple_pendulum.hpp"

#include <unsupported/Eigen/AutoDiff>

#include <gtest/gtest.h>

#include <complex>

namespace {

using namespace simple_pendulum;

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

} // namespace
