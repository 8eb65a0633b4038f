#pragma once

#include "call.hpp"

#include <models/cornering_car.hpp>

#include <array>

/// A car on brush tyres with relaxation lengths, and the state in a turn at which its programs are called.
namespace embedded::car {

using namespace cornering_car;

struct calls {
  using system = System;
  static constexpr std::array<double, 29> given{0,     0,      0.1,   0.2,    -0.3, // x, y, angles
                                                20,    -0.4,   0.3,   66.2,   67.5, // u, v, r, wheels
                                                0.001, -0.004, 0.002, -0.003,       // deflections
                                                0.05,  0,      0,     100,          // delta, its rates, T
                                                1500,  2400,   9.81,  1.2,    1.6,  0.3, // m, J, g, a, b, R
                                                0.9,   9e4,    1.1e5, 0.4,    0.1};      // mu, C, s, v0
  static constexpr std::size_t varied = state_and_inputs<system>;
  static constexpr double spread = 0.002;
};

} // namespace embedded::car
