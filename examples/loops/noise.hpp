#pragma once

#include <cstdint>

/// Random numbers that are the same on every machine, with mean 0 and standard deviation 1: nearly normal, as
/// sums of twelve uniform numbers.
class noise {
public:
  template <class T>
  T next() {
    std::int32_t sum = 0;
    for (int i = 0; i < 12; ++i) {
      state_ = 1664525U * state_ + 1013904223U; // Press et al., Numerical Recipes in C, 1992, section 7.1
      sum += static_cast<std::int32_t>(state_ >> 9U);
    }
    return static_cast<T>(sum - 6 * unit) / static_cast<T>(unit);
  }

private:
  static constexpr std::int32_t unit = std::int32_t{1} << 23;
  std::uint32_t state_ = 0;
};
