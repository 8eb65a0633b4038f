#pragma once

#include <kanexpr/control.hpp>
#include <models/bicycle.hpp>

/// A torque at the fork keeps a bicycle upright at speeds at which it would fall on its own, and a torque at
/// the rear wheel keeps it at the desired speed. The compiler computes the gains for each speed.
namespace balanced_bicycle {

using namespace bicycle;

constexpr input<"D", newton * meter> D; // between rear wheel and frame
struct Driven : extended<SteeredSystem, inputs<D>, loads<torque_between<WR, Frame, D * Frame::y>>> {};

constexpr double rear_radius = 0.3, front_radius = 0.35;  // m
constexpr double period = 0.01, slowest = 2, fastest = 6; // s, m/s
constexpr double drive = 60;                              // N m for each m/s below the desired speed

/// The gains for lean, steer and their rates, upright at the speed v.
constexpr auto regulator_at(double v) {
  const auto both = linearization<Driven>::explicit_form.constant(
      constant_state<Driven>(
          {{q1, 0}, {q2, 0}, {q5, 0}, {u2, 0}, {u3, v / rear_radius}, {u5, 0}, {u6, v / front_radius}}),
      {}, constant_inputs<Driven>({{T, 0}, {D, 0}}));
  const auto A = std::get<0>(both).at({1, 2, 3, 5}, {1, 2, 3, 5});
  const auto B = std::get<1>(both).at({1, 2, 3, 5}, {0});
  const auto linear = discretize(A, B, period);
  return dlqr(linear.A, linear.B, {10, 1, 1, 0.1}, {0.01});
}

constexpr auto gains = gain_schedule<9>(slowest, fastest, regulator_at);
static_assert(gains);

/// The torques until the next call, one period later, at the state x.
template <class Number>
input_values<Driven, Number> torques(const state<Driven, Number>& x, Number wanted_speed) {
  static constexpr auto K = in_numbers<Number>(gains);
  const Number speed = Number(rear_radius) * x[u3];
  const Eigen::Matrix<Number, 4, 1> off(x[q2], x[q5], x[u2], x[u5]);
  input_values<Driven, Number> r;
  r[T] = -(numeric::as_eigen(K(speed)) * off).value();
  r[D] = Number(drive) * (wanted_speed - speed);
  return r;
}

} // namespace balanced_bicycle
