#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/numeric/elementary.hpp>
#include <kanexpr/numeric/elimination.hpp>

#include <type_traits>

namespace kanexpr::numeric {

/// What elimination needs of numbers in a constant expression. A constant expression must not divide by zero:
/// a vanishing pivot is left out, and whoever solves looks at the least pivot first.
template <class T>
struct constant_elimination_math_of {
  static constexpr T magnitude(T x) {
    if constexpr (std::is_same_v<T, double>)
      return elementary::abs(x);
    else
      return x < 0 ? -x : x;
  }
  static constexpr T reciprocal(T x) { return equal(x, T(0)) ? 0 : 1 / x; }
  static constexpr T root(T x) { return static_cast<T>(elementary::sqrt(static_cast<double>(x))); }
  static constexpr void exchange_if_positive(T d, T& a, T& b) {
    if (!(d > 0)) return;
    const T kept = a;
    a = b;
    b = kept;
  }
};
using constant_elimination_math = constant_elimination_math_of<double>;

} // namespace kanexpr::numeric
