#pragma once

#include <functional>
#include <string_view>

namespace kanexpr::base {

/// Compares exactly, on purpose; compilers can warn about every `==` between floating-point numbers.
template <class Value>
constexpr bool equal(const Value& x, const Value& y) {
  return std::equal_to<Value>{}(x, y);
}

constexpr bool equal(double x, double y) { return x <= y && x >= y; } // faster in constant evaluation

/// Compares texts from the end, because names often differ only there and compilers interpret every step.
constexpr bool equal(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  const char *const begin = a.data(), *other = b.data() + b.size();
  for (const char* letter = begin + a.size(); letter != begin;)
    if (*--letter != *--other) return false;
  return true;
}

/// True if the value is not NaN.
template <class Value>
constexpr bool is_number(const Value& x) {
  return equal(x, x);
}

} // namespace kanexpr::base
