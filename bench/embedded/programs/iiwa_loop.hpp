#pragma once

#include "call.hpp"

#include <loops/computed_torque.hpp>

#include <array>

/// Two seconds of the iiwa under its controller: the state after each half second. It is given the angles at
/// first.
struct program {
  static constexpr std::array<double, 7> given{-0.2, -0.4, -0.2, 1.6, -0.2, -0.8, -0.2};
  static constexpr std::size_t varied = given.size(), found = 57;
  static constexpr double spread = 0.2;

  template <class T>
  static void run(const T* given, T* found) {
    kanexpr::state<computed_torque::System, T> start;
    start.q() = Eigen::Map<const Eigen::Matrix<T, 7, 1>>(given);
    computed_torque::loop<T> arm(start);
    kanexpr::status made;
    for (int part = 0; part < 4; ++part) {
      for (int k = 0; k < 500 && made; ++k) made = arm.go_on();
      found = embedded::put(found, arm.x);
    }
    *found = embedded::as_number<T>(made);
  }

  /// Whether the arm is on its path.
  template <class T>
  static bool is_well(const T* found) {
    const Eigen::Map<const Eigen::Matrix<T, 7, 1>> angles(found + 42);
    return found[56] == 1 &&
           (angles - computed_torque::motion_at(T(2)).angles).cwiseAbs().maxCoeff() < T(1e-3);
  }
};
