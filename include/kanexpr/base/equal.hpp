#pragma once

#include <functional>

namespace kanexpr::base {

/// Compares exactly, on purpose; compilers can warn about every `==` between floating-point numbers.
template <class Value>
constexpr bool equal(const Value& x, const Value& y) {
  return std::equal_to<Value>{}(x, y);
}

constexpr bool equal(double x, double y) { return x <= y && x >= y; } // faster in constant evaluation

/// True if the value is not NaN.
template <class Value>
constexpr bool is_number(const Value& x) {
  return equal(x, x);
}

} // namespace kanexpr::base
