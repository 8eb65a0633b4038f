#pragma once

#include "call.hpp"

#include <controllers/computed_torque.hpp>

#include <array>

/// The torques that let the joints of the iiwa follow a motion. It is given the state and the time.
struct program {
  static constexpr std::array<double, 15> given{0.3,  -0.5, 0.7, -0.9, 1.1, -0.6, 0.4, // angles
                                                -0.2, 0.4,  0.1, 0.5,  0.3, -0.4, 0.2, // speeds
                                                0.9};
  static constexpr std::size_t varied = given.size(), found = 7;
  static constexpr double spread = 0.5;

  template <class T>
  [[gnu::always_inline]] static void run(const T* given, T* found) {
    const Eigen::Map<const Eigen::Matrix<T, 14, 1>> measured(given);
    const kanexpr::state<computed_torque::System, T> x(measured);
    embedded::put(found, computed_torque::torques(given[14], x));
  }
};
