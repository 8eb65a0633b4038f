#pragma once

#include <controllers/computed_torque.hpp>
#include <kanexpr/fixed_step.hpp>

namespace computed_torque {

/// The arm under its controller, both in the same numbers.
template <class T>
class loop {
public:
  using state = kanexpr::state<System, T>;

  explicit loop(const state& start) : x(start) {}

  /// Goes on by a period.
  status go_on() {
    r = torques(t, x);
    return runge_kutta_4<System>{}(t, x, T(period), parameter_values<System, T>(), r);
  }

  /// Of the angles, from those that are wanted.
  joints<T> error() const { return x.q() - motion_at(t).angles; }

  T t = 0;
  state x;
  input_values<System, T> r = input_values<System, T>::Zero();
};

} // namespace computed_torque
