#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/numeric/elementary.hpp>
#include <kanexpr/numeric/elimination.hpp>

namespace kanexpr::numeric {

/// The scalar operations for elimination in a constant expression. A constant expression must not divide by
/// zero, so a vanishing pivot is skipped; callers check the smallest pivot first.
struct constant_elimination_math {
  template <class Number>
  static constexpr Number magnitude(Number x) {
    return x < 0 ? -x : x;
  }
  template <class Number>
  static constexpr Number reciprocal(Number x) {
    return base::equal(x, Number(0)) ? Number(0) : 1 / x;
  }
  static constexpr double root(double x) { return numeric::elementary::sqrt(x); }
  template <class Number>
  static constexpr void exchange_if_positive(Number d, Number& a, Number& b) {
    if (!(d > 0)) return;
    const Number kept = a;
    a = b;
    b = kept;
  }
};

} // namespace kanexpr::numeric
