#pragma once

#include "call.hpp"

#include <loops/balanced_cart.hpp>

#include <array>
#include <cmath>

/// Five seconds of the cart under its controller: where it is after each of them. It is given the state at
/// first and what the controller guesses that it is.
struct program {
  static constexpr std::array<double, 8> given{-0.5, balanced_cart::upright + 0.2, 0, 0,
                                               -0.4, balanced_cart::upright + 0.1, 0, 0};
  static constexpr std::size_t varied = given.size(), found = 21;
  static constexpr double spread = 0.1;

  template <class T>
  static void run(const T* given, T* found) {
    using state = kanexpr::state<balanced_cart::cart, T>;
    const Eigen::Map<const Eigen::Matrix<T, 4, 1>> start(given), guess(given + 4);
    balanced_cart::loop<T> cart{state(start), state(guess)};
    kanexpr::status made;
    for (int second = 0; second < 5; ++second) {
      for (int k = 0; k < 200 && made; ++k) made = cart.go_on();
      found = embedded::put(found, cart.x);
    }
    *found = embedded::as_number<T>(made);
  }

  /// Whether the pendulum stands and the cart is near where it belongs.
  template <class T>
  static bool is_well(const T* found) {
    const T* const last = found + 16;
    return found[20] == 1 && std::abs(last[0]) < T(0.1) &&
           std::abs(last[1] - T(balanced_cart::upright)) < T(0.03);
  }
};
