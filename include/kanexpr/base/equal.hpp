#pragma once

#include <functional>

namespace kanexpr::numeric {

/// Exactly equal, and meant so: compilers can be told to warn of every `==` between floating-point numbers.
template <class T>
constexpr bool equal(const T& x, const T& y) {
  return std::equal_to<T>{}(x, y);
}

constexpr bool equal(double x, double y) { return x <= y && x >= y; } // which compilers interpret sooner

/// Not NaN.
template <class T>
constexpr bool is_number(const T& x) {
  return equal(x, x);
}

} // namespace kanexpr::numeric
