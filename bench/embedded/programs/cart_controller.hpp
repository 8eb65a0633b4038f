#pragma once

#include "cart.hpp"

/// The force that keeps the pendulum of the cart upright, F = -K (x - x0), within what the motor gives. K is
/// that of the linear-quadratic regulator with the weights 1, 1, 0.1, 0.1 of the state and 0.1 of the force.
struct program : embedded::cart::calls {
  static constexpr std::size_t found = 1;

  template <class T>
  [[gnu::always_inline]] static void run(const T* given, T* found) {
    const Eigen::Matrix<T, 4, 1> K{T(-3.16227766), T(60.30706731), T(-5.27859908), T(16.06793682)};
    const Eigen::Matrix<T, 4, 1> x0{T(0), T(upright), T(0), T(0)};
    const embedded::arguments<embedded::cart::system, T> at(given);
    *found = embedded::within(-K.dot(at.x - x0), T(-20), T(20));
  }
};
