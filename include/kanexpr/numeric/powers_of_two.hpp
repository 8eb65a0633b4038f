#pragma once

#include <kanexpr/numeric/elementary.hpp>

#include <bit>
#include <cstdint>
#include <limits>
#include <type_traits>

/// Powers of two represented by their exponents: products with them are exact, and sums of exponents do not
/// overflow.
namespace kanexpr::numeric {

/// Smaller than the exponent of any nonzero number, even after other exponents are added to it.
inline constexpr int exponent_of_zero = -(1 << 20);
constexpr bool is_exponent_of_zero(int exponent) { return exponent < exponent_of_zero / 2; }

/// Infinity, without the warnings of compilers that assume finite numbers.
template <class Number>
inline constexpr Number infinity = static_cast<Number>(numeric::elementary::detail::infinity);
template <class Number>
inline constexpr Number not_a_number = static_cast<Number>(numeric::elementary::detail::not_a_number);

/// Returns the bits of a number, or of the double it converts to, without the sign.
template <class Number>
constexpr auto magnitude_bits(Number x) {
  using bits = std::conditional_t<std::is_same_v<Number, float>, std::uint32_t, std::uint64_t>;
  using number = std::conditional_t<std::is_same_v<Number, float>, float, double>;
  bits found = std::bit_cast<bits>(static_cast<number>(x));
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
  if (!std::is_constant_evaluated()) asm("" : "+r"(found)); // hides the origin of the bits from clang++
#endif
  return static_cast<bits>(found << 1) >> 1;
}

/// Tests the bits, so that both functions work with -ffast-math.
template <class Number>
constexpr bool is_finite(Number x) {
  return magnitude_bits(x) < magnitude_bits(infinity<Number>);
}
template <class Number>
constexpr bool is_nan(Number x) {
  return magnitude_bits(x) > magnitude_bits(infinity<Number>);
}

/// Returns the k for which 2ᵏ ≤ |x| < 2ᵏ⁺¹, for finite x.
template <class Number>
constexpr int exponent_of(Number x) {
  constexpr bool is_short = std::is_same_v<Number, float>;
  constexpr int digits = is_short ? 23 : 52, bias = is_short ? 127 : 1023, size = is_short ? 32 : 64;
  const auto magnitude = magnitude_bits(x);
  if (magnitude == 0) return exponent_of_zero;
  const int biased = static_cast<int>(magnitude >> digits);
  return biased > 0 ? biased - bias : size - digits - bias - std::countl_zero(magnitude);
}

/// Returns 2ᵏ if it is a normal number.
template <class Number>
constexpr Number power_of_two(int k) {
  if constexpr (std::is_same_v<Number, float>)
    return std::bit_cast<float>(static_cast<std::uint32_t>(k + 127) << 23);
  else
    return static_cast<Number>(numeric::elementary::detail::power_of_two(k));
}

/// Returns x 2ᵏ; if the product is too large, returns infinity without an operation that overflows.
template <class Number>
constexpr Number times_power_of_two(Number x, int k) {
  constexpr int too_large = std::numeric_limits<Number>::max_exponent, most = too_large - 2;
  if (exponent_of(x) + k >= too_large) return x < 0 ? -infinity<Number> : infinity<Number>;
  if (is_exponent_of_zero(exponent_of(x) + k)) return 0;
  for (; k > most; k -= most) x *= power_of_two<Number>(most);
  for (; k < -most; k += most) x *= power_of_two<Number>(-most);
  return x * power_of_two<Number>(k);
}

} // namespace kanexpr::numeric
