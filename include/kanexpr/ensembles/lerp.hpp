#pragma once

#include <kanexpr/numeric/powers_of_two.hpp>

#include <algorithm>
#include <cmath>

namespace kanexpr::ensembles {

/// Linear interpolation between two numbers. It is monotonic, stays between the two numbers even if their
/// difference overflows, and gives the same bits whether or not the compiler contracts products and sums.
inline double lerp(double from, double to, double part) {
  if (part >= 1) return to;
  const double width = to - from;
  const double at =
      numeric::is_finite(width) ? std::fma(part, width, from) : std::fma(part, to, (1 - part) * from);
  return std::clamp(at, (std::min)(from, to), (std::max)(from, to));
}

} // namespace kanexpr::ensembles
