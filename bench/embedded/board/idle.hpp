#pragma once

#include <array>
#include <cstddef>

/// A program that does nothing: what its image has, every image has.
struct program {
  static constexpr std::array<double, 1> given{};
  static constexpr std::size_t varied = 0, found = 0;
  static constexpr double spread = 0;
  template <class T>
  static void run(const T*, T*) {}
};
