#pragma once

#include <kanexpr/numeric/powers_of_two.hpp>

#include <algorithm>
#include <cmath>

namespace kanexpr::ensembles {

/// What lies a part of the way from a number to another: never beyond them, never back where the part grows,
/// and with the same bits whether or not the compiler fuses products with sums.
inline double between(double from, double to, double part) {
  if (part >= 1) return to;
  const double width = to - from; // beyond the greatest number if they have different signs
  const double at =
      numeric::is_finite(width) ? std::fma(part, width, from) : std::fma(part, to, (1 - part) * from);
  return std::clamp(at, (std::min)(from, to), (std::max)(from, to));
}

} // namespace kanexpr::ensembles
