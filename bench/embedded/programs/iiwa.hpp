#pragma once

#include "call.hpp"

#include <models/iiwa.hpp>

#include <array>

/// The KUKA LBR iiwa, its joints anywhere, where its programs are called.
namespace embedded::iiwa {

using namespace ::iiwa;

struct calls {
  using system = System;
  static constexpr std::array<double, 21> given{0.3,  -0.5, 0.7, -0.9, 1.1, -0.6, 0.4,  // angles
                                                -0.2, 0.4,  0.1, 0.5,  0.3, -0.4, 0.2,  // speeds
                                                5,    -20,  3,   10,   1,   -1,   0.1}; // torques
  static constexpr std::size_t varied = state_and_inputs<system>;
  static constexpr double spread = 0.5;
};

} // namespace embedded::iiwa
