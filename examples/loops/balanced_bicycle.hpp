#pragma once

#include <controllers/balanced_bicycle.hpp>
#include <loops/noise.hpp>

#include <algorithm>

namespace balanced_bicycle {

/// The bicycle and its controller, both in the same scalar type. The rider's hands are not steady.
template <class Number>
class loop {
public:
  using state = kanexpr::state<Driven, Number>;

  /// Upright at the fastest speed, with a push to the side, which is a rate of lean in rad/s.
  explicit loop(Number push) {
    x[u2] = push;
    x[u3] = Number(fastest / rear_radius);
    x[u6] = Number(fastest / front_radius);
  }

  /// Slows down to the slowest speed.
  Number wanted_speed() const { return std::max(Number(slowest), Number(fastest) - Number(braking) * t); }

  /// Advances by one period.
  status go_on() {
    r = torques(x, wanted_speed());
    input_values<Driven, Number> acting = r;
    acting[T] += Number(unsteadiness) * random_.next<Number>();
    return runge_kutta_4<Driven>{}(t, x, Number(period), parameter_values<Driven, Number>(), acting);
  }

  Number t = 0;
  state x;
  input_values<Driven, Number> r = input_values<Driven, Number>::Zero();

private:
  static constexpr double unsteadiness = 4, braking = 0.4; // N m, m/s²

  noise random_;
};

} // namespace balanced_bicycle
