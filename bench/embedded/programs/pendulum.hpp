#pragma once

#include "call.hpp"

#include <models/simple_pendulum.hpp>

#include <array>

/// The pendulum of the README, where its programs are called.
namespace embedded::pendulum {

using namespace simple_pendulum;

struct calls {
  using system = System;
  static constexpr std::array<double, 7> given{0.3, -0.4, 0.5, 2, 0.5, 9.81, 0.1}; // q, u; T; m, l, g, c
  static constexpr std::size_t varied = 3;
  static constexpr double spread = 1;
};

} // namespace embedded::pendulum
