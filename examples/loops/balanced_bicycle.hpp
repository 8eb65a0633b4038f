#pragma once

#include <controllers/balanced_bicycle.hpp>
#include <loops/noise.hpp>

#include <algorithm>

namespace balanced_bicycle {

/// The bicycle under its controller, both in numbers of type T. The hands of the rider are not steady.
template <class T>
class loop {
public:
  using state = kanexpr::state<Driven, T>;

  /// Upright at the fastest speed, it is pushed to the side: a rate of lean, in rad/s.
  explicit loop(T push) {
    x[u2] = push;
    x[u3] = T(fastest / rear_radius);
    x[u6] = T(fastest / front_radius);
  }

  /// It slows down to the slowest.
  T wanted_speed() const { return std::max(T(slowest), T(fastest) - T(braking) * t); }

  /// Goes on by a period.
  status go_on() {
    r = torques(x, wanted_speed());
    input_values<Driven, T> acting = r;
    acting[bicycle::T] += T(unsteadiness) * random_.next<T>();
    return runge_kutta_4<Driven>{}(t, x, T(period), parameter_values<Driven, T>(), acting);
  }

  T t = 0;
  state x;
  input_values<Driven, T> r = input_values<Driven, T>::Zero();

private:
  static constexpr double unsteadiness = 4, braking = 0.4; // N m, m/s²

  noise random_;
};

} // namespace balanced_bicycle
