#pragma once

#include <kanexpr/symbolic/numbers/number.hpp>

#include <cstdint>

namespace kanexpr::symbolic {

/// A computed number as a constant: the exact fraction with a denominator up to 1000 that equals it except
/// for rounding, if there is one, and the double otherwise. The fraction is searched among the convergents of
/// the continued fraction.
constexpr number nearby_fraction(double value) {
  const double size = value < 0 ? -value : value;
  std::int64_t above = 1, below = 0, above_before = 0, below_before = 1;
  double rest = size;
  while (rest < 1e6) {
    const auto whole = static_cast<std::int64_t>(rest);
    const std::int64_t next_above = whole * above + above_before, next_below = whole * below + below_before;
    above_before = above, below_before = below;
    above = next_above, below = next_below;
    if (below > 1000) break;
    const double error = static_cast<double>(above) / static_cast<double>(below) - size;
    if (error * error <= 25e-32 * size * size) return exactly(value < 0 ? -above : above, below);
    const double fraction = rest - static_cast<double>(whole);
    if (fraction * 1e6 < 1) break;
    rest = 1 / fraction;
  }
  return real(value);
}

} // namespace kanexpr::symbolic
