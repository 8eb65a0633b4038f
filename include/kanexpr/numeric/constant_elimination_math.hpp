#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/numeric/elementary.hpp>
#include <kanexpr/numeric/elimination.hpp>

namespace kanexpr::numeric {

/// What elimination needs of numbers in a constant expression. A constant expression must not divide by zero:
/// a vanishing pivot is left out, and whoever solves looks at the least pivot first.
struct constant_elimination_math {
  static constexpr double magnitude(double x) { return elementary::abs(x); }
  static constexpr double reciprocal(double x) { return equal(x, 0.0) ? 0 : 1 / x; }
  static constexpr double root(double x) { return elementary::sqrt(x); }
  static constexpr void exchange_if_positive(double d, double& a, double& b) {
    if (!(d > 0)) return;
    const double kept = a;
    a = b;
    b = kept;
  }
};

} // namespace kanexpr::numeric
