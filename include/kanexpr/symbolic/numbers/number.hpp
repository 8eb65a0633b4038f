#pragma once

#include <kanexpr/base/equal.hpp>

#include <bit>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace kanexpr::symbolic {

/// A constant: an exact fraction if it is written as one (such as `/4`), otherwise a double.
///
/// Exact arithmetic falls back to doubles when a numerator or denominator would overflow.
struct number {
  std::int64_t numerator = 0;
  std::int64_t denominator = 1; ///< positive; 0 means that the value is `real`
  double real = 0;

  constexpr bool exact() const { return denominator != 0; }
  constexpr bool is_zero() const { return numerator == 0 && denominator != 0; }
  constexpr bool integer() const { return denominator == 1; }
  constexpr double value() const {
    return exact() ? static_cast<double>(numerator) / static_cast<double>(denominator) : real;
  }
  constexpr bool negative() const { return exact() ? numerator < 0 : real < 0; }
  constexpr bool operator==(const number& other) const {
    return numerator == other.numerator && denominator == other.denominator && base::equal(real, other.real);
  }
};

constexpr bool is_finite(double value) {
  return (std::bit_cast<std::uint64_t>(value) & ~(std::uint64_t{1} << 63)) < std::uint64_t{0x7ff} << 52;
}
constexpr bool is_finite(const number& n) { return n.denominator != 0 || is_finite(n.real); }

/// A double; if it holds an integer, it becomes exact, so that `1.0*x` is `x`.
constexpr number real(double value) {
  constexpr double integers_end = 9007199254740992.0; // 2^53
  if (value > -integers_end && value < integers_end) {
    const auto whole = static_cast<std::int64_t>(value);
    if (base::equal(static_cast<double>(whole), value)) return {whole, 1, 0};
  }
  return {0, 0, value};
}

constexpr number exactly(std::int64_t numerator, std::int64_t denominator = 1) {
  constexpr std::int64_t lowest = (std::numeric_limits<std::int64_t>::min)(); // its negative overflows
  if (numerator == lowest || denominator == lowest)
    return real(static_cast<double>(numerator) / static_cast<double>(denominator));
  if (denominator < 0) numerator = -numerator, denominator = -denominator;
  std::int64_t a = numerator < 0 ? -numerator : numerator, b = denominator;
  while (b != 0) {
    const std::int64_t rest = a % b;
    a = b;
    b = rest;
  }
  if (a > 1) numerator /= a, denominator /= a;
  return {numerator, denominator, 0};
}

/// The result of an undefined operation.
constexpr number no_number() { return {0, 0, std::numeric_limits<double>::quiet_NaN()}; }

/// Whether a result computed as a long double fits into a double; constant expressions must not overflow.
constexpr bool stays_finite(long double wide) {
  constexpr auto end = static_cast<long double>((std::numeric_limits<double>::max)());
  return wide <= end && wide >= -end;
}

constexpr number operator-(const number& a) {
  return a.exact() ? number{-a.numerator, a.denominator, 0} : number{0, 0, -a.real};
}

/// Decimal numbers that cancel up to rounding give zero: 0.1 + 0.2 - 0.3.
constexpr number operator+(const number& a, const number& b) {
  if (a.exact() && b.exact()) {
    std::int64_t left = 0, right = 0, sum = 0, below = 0;
    if (!__builtin_mul_overflow(a.numerator, b.denominator, &left) &&
        !__builtin_mul_overflow(b.numerator, a.denominator, &right) &&
        !__builtin_add_overflow(left, right, &sum) &&
        !__builtin_mul_overflow(a.denominator, b.denominator, &below))
      return exactly(sum, below);
  }
  const double x = a.value(), y = b.value();
  if (std::is_constant_evaluated() &&
      !(is_finite(x) && is_finite(y) &&
        stays_finite(static_cast<long double>(x) + static_cast<long double>(y))))
    return no_number();
  const double sum = x + y, least = 0x1p-50 * (x < 0 ? -x : x);
  return real(is_finite(sum) && sum <= least && sum >= -least ? 0 : sum);
}

constexpr number operator-(const number& a, const number& b) { return a + -b; }

constexpr number operator*(const number& a, const number& b) {
  if (a.exact() && b.exact()) {
    std::int64_t above = 0, below = 0;
    if (!__builtin_mul_overflow(a.numerator, b.numerator, &above) &&
        !__builtin_mul_overflow(a.denominator, b.denominator, &below))
      return exactly(above, below);
  }
  const double x = a.value(), y = b.value();
  if (std::is_constant_evaluated() &&
      !(is_finite(x) && is_finite(y) &&
        stays_finite(static_cast<long double>(x) * static_cast<long double>(y))))
    return no_number();
  return real(x * y);
}

/// base^exponent by repeated squaring, for a nonnegative exponent.
template <class Value, class Multiply>
constexpr Value power_by_squaring(Value base, std::uint64_t exponent, Value one, Multiply multiply) {
  for (; exponent > 0; exponent /= 2) {
    if (exponent % 2 != 0) one = multiply(one, base);
    if (exponent > 1) base = multiply(base, base);
  }
  return one;
}

/// Requires that `b` is not zero.
constexpr number operator/(const number& a, const number& b) {
  if (a.exact() && b.exact()) {
    std::int64_t above = 0, below = 0;
    if (!__builtin_mul_overflow(a.numerator, b.denominator, &above) &&
        !__builtin_mul_overflow(a.denominator, b.numerator, &below))
      return exactly(above, below);
  }
  const double x = a.value(), y = b.value();
  if (std::is_constant_evaluated() &&
      !(is_finite(x) && is_finite(y) &&
        stays_finite(static_cast<long double>(x) / static_cast<long double>(y))))
    return no_number();
  return real(x / y);
}

} // namespace kanexpr::symbolic
