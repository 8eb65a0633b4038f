#pragma once

#include "call.hpp"

#include <models/n_pendulum_cart.hpp>

#include <array>
#include <numbers>

/// A pendulum on a cart, near upright, where its programs are called.
namespace embedded::cart {

using namespace n_pendulum_cart;
struct calls {
  using system = System<1>;
  static constexpr double upright = std::numbers::pi / 2;
  static constexpr std::array<double, 9> given{0.2, upright + 0.1, -0.3, 0.4,   // q0, q1, u0, u1
                                               0.7,                             // F
                                               1.5, 0.4,           0.8,  9.81}; // m0, m1, l0, g
  static constexpr std::size_t varied = state_and_inputs<system>;
  static constexpr double spread = 0.3;
};

} // namespace embedded::cart
