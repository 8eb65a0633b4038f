#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/numeric/elementary.hpp>
#include <kanexpr/numeric/elimination.hpp>

namespace kanexpr::numeric {

/// What elimination needs of numbers in a constant expression. A constant expression must not divide by zero:
/// a vanishing pivot is left out, and whoever solves looks at the least pivot first.
struct constant_elimination_math {
  template <class T>
  static constexpr T magnitude(T x) {
    return x < 0 ? -x : x;
  }
  template <class T>
  static constexpr T reciprocal(T x) {
    return equal(x, T(0)) ? T(0) : 1 / x;
  }
  static constexpr double root(double x) { return elementary::sqrt(x); }
  template <class T>
  static constexpr void exchange_if_positive(T d, T& a, T& b) {
    if (!(d > 0)) return;
    const T kept = a;
    a = b;
    b = kept;
  }
};

} // namespace kanexpr::numeric
