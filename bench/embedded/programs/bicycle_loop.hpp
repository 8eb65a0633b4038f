#pragma once

#include "call.hpp"

#include <loops/balanced_bicycle.hpp>

#include <array>
#include <cmath>

/// Twelve seconds of the bicycle under its controller, while it slows down: how it goes after each three of
/// them. It is given the rate of lean at first.
struct program {
  static constexpr std::array<double, 1> given{0.4};
  static constexpr std::size_t varied = given.size(), found = 41;
  static constexpr double spread = 0.3;

  template <class T>
  static void run(const T* given, T* found) {
    using namespace balanced_bicycle;
    balanced_bicycle::loop<T> bicycle(given[0]);
    kanexpr::status made;
    for (int part = 0; part < 4; ++part) {
      for (int k = 0; k < 300 && made; ++k) made = bicycle.go_on();
      found = embedded::put(found, bicycle.x);
    }
    *found = embedded::as_number<T>(made);
  }

  /// Whether the bicycle stands.
  template <class T>
  static bool is_well(const T* found) {
    return found[40] == 1 && std::abs(found[31]) < T(0.05);
  }
};
