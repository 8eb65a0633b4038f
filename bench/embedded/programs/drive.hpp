#pragma once

#include "call.hpp"

#include <models/elastic_drive.hpp>

#include <array>

/// A motor with an elastic shaft under a PI controller with limits, where its programs are called.
namespace embedded::drive {

using namespace elastic_drive;

struct calls {
  using system = System;
  static constexpr std::array<double, 19> given{0.3,  0.2,    4,   3.5,  0.4, 0.8, // angles, speeds, s and i
                                                6,    0.1,                         // reference, T
                                                4e-4, 1.6e-3, 0.5, 2e-3, 1.2, 1.2e-3,
                                                0.08, 0.25,   1.2, 12,   0.2};
  static constexpr std::size_t varied = 8;
  static constexpr double spread = 0.5;
};

} // namespace embedded::drive
