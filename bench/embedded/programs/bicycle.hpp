#pragma once

#include "call.hpp"

#include <models/bicycle.hpp>

#include <array>

/// The benchmark bicycle, leaning and steered at 4.6 m/s, where its programs are called.
namespace embedded::bicycle {

using namespace ::bicycle;

struct calls {
  using system = BoundSystem;
  // The dependent ones, q4 and u1, u4, u6, satisfy the constraints.
  static constexpr std::array<double, 10> given{0.3,
                                                0.2,
                                                -0.3,
                                                -0.0038062459232209951, // q1, q2, q5, q4
                                                0.5,
                                                4.6 / 0.3,
                                                -0.7,
                                                1.42235879983108, // u2, u3, u5, u1
                                                -0.020394201599669273,
                                                13.869403258938132}; // u4, u6
  static constexpr std::size_t varied = state_and_inputs<system>;
  static constexpr double spread = 0.05;
};

} // namespace embedded::bicycle
