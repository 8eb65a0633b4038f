#pragma once

#include <controllers/computed_torque.hpp>
#include <kanexpr/fixed_step.hpp>

namespace computed_torque {

/// The arm and its controller, both in the same scalar type.
template <class T>
class loop {
public:
  using state = kanexpr::state<System, T>;

  explicit loop(const state& start) : x(start) {}

  /// Advances by one period.
  status go_on() {
    r = torques(t, x);
    return runge_kutta_4<System>{}(t, x, T(period), parameter_values<System, T>(), r);
  }

  /// The deviation of the angles from the desired ones.
  joints<T> error() const { return x.q() - motion_at(t).angles; }

  T t = 0;
  state x;
  input_values<System, T> r = input_values<System, T>::Zero();
};

} // namespace computed_torque
