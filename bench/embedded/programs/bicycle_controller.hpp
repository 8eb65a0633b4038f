#pragma once

#include "call.hpp"

#include <controllers/balanced_bicycle.hpp>

#include <array>

/// The torques that keep the bicycle upright and at the speed that is wanted: gains by the speed, between
/// those that the compiler computed. It is given the state and that speed.
struct program {
  static constexpr std::array<double, 11> given{0.3,   0.2, -0.3, -0.004, // q1, q2, q5, q4
                                                0.5,   12,  -0.7, 1.4,    // u2, u3, u5, u1
                                                -0.02, 10,  3.5};         // u4, u6; the speed
  static constexpr std::size_t varied = given.size(), found = 2;
  static constexpr double spread = 9; // a speed below those of the table, too

  template <class T>
  [[gnu::always_inline]] static void run(const T* given, T* found) {
    using state = kanexpr::state<balanced_bicycle::Driven, T>;
    const state x(Eigen::Map<const Eigen::Matrix<T, 10, 1>>{given});
    embedded::put(found, balanced_bicycle::torques(x, given[10]));
  }
};
