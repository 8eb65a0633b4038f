#pragma once

#include <controllers/balanced_cart.hpp>
#include <loops/noise.hpp>

namespace balanced_cart {

/// The cart and its controller, both in the same scalar type. The disturbance is the one that the controller
/// expects.
template <class T>
class loop {
public:
  using state = kanexpr::state<cart, T>;

  loop(const state& start, const state& guess) : x(start), control(guess, uncertainty()) {}

  /// Advances by one period.
  status go_on() {
    const T place = x[q<0>] + T(place_noise) * random_.next<T>();
    const T angle = x[q<1>] + T(angle_noise) * random_.next<T>();
    if (const status s = control({place, angle}); !s) return s;
    const input_values<cart, T> acting(control.force[F] + T(disturbing_force) * random_.next<T>());
    return runge_kutta_4<cart>{}(t, x, T(period), parameters_in<T>(), acting);
  }

  T t = 0;
  state x;
  controller<T> control;

private:
  // The error of the initial guess.
  static typename controller<T>::covariance uncertainty() {
    return Eigen::Matrix<T, 4, 1>(T(0.01), T(0.01), T(0.04), T(0.04)).asDiagonal();
  }

  noise random_;
};

} // namespace balanced_cart
