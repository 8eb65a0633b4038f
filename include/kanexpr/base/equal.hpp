#pragma once

#include <functional>

namespace kanexpr::numeric {

/// Exactly equal, and meant so: compilers can be told to warn of every `==` between floating-point numbers.
template <class Value>
constexpr bool equal(const Value& x, const Value& y) {
  return std::equal_to<Value>{}(x, y);
}

constexpr bool equal(double x, double y) { return x <= y && x >= y; } // which compilers interpret sooner

/// Not NaN.
template <class Value>
constexpr bool is_number(const Value& x) {
  return equal(x, x);
}

} // namespace kanexpr::numeric
