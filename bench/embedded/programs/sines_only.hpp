#pragma once

#include "call.hpp"

#include <kanexpr/lower/scalar_math.hpp>

#include <algorithm>
#include <array>
#include <cmath>

/// The sines and cosines of some angles of every quadrant, and whether those of two angles that are out of
/// reach are not numbers.
struct program {
  static constexpr std::array<double, 10> given{0.3, -1.2, 2, -3.5, 5, 7, 101, -20000, 131073, -INFINITY};
  static constexpr std::size_t varied = 8, found = 17;
  static constexpr double spread = 1.5;

  template <class T>
  [[gnu::always_inline]] static void run(const T* given, T* found) {
    T angle[10], sine[10], cosine[10];
    std::copy_n(given, 10, angle);
    kanexpr::lower::scalar_math<T>::template sincos<10>(angle, sine, cosine);
    std::copy_n(sine, 8, found);
    std::copy_n(cosine, 8, found + 8);
#if defined(KANEXPR_ANGLES_WITHIN_REACH)
    found[16] = static_cast<T>(std::isnan(sine[8]) + std::isnan(cosine[8]) + std::isnan(sine[9]) +
                               std::isnan(cosine[9]));
#else
    found[16] = 4;
#endif
  }
};
