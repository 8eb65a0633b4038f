#pragma once

#include <kanexpr/numeric/elementary.hpp>

#include <bit>
#include <cstdint>
#include <limits>
#include <type_traits>

/// Powers of two as their exponents: products with them round nothing, and their sums do not overflow.
namespace kanexpr::numeric {

/// Less than that of any number, also beside other exponents.
inline constexpr int exponent_of_zero = -(1 << 20);
constexpr bool is_exponent_of_zero(int exponent) { return exponent < exponent_of_zero / 2; }

/// What compilers warn of where numbers are told to be finite.
template <class T>
inline constexpr T infinity = static_cast<T>(elementary::detail::infinity);
template <class T>
inline constexpr T not_a_number = static_cast<T>(elementary::detail::not_a_number);

/// The bits of a number, or of the double that it is, without the sign.
template <class T>
constexpr auto magnitude_bits(T x) {
  using bits = std::conditional_t<std::is_same_v<T, float>, std::uint32_t, std::uint64_t>;
  using number = std::conditional_t<std::is_same_v<T, float>, float, double>;
  bits found = std::bit_cast<bits>(static_cast<number>(x));
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
  if (!std::is_constant_evaluated()) asm("" : "+r"(found)); // clang++ knows whose bits they are
#endif
  return static_cast<bits>(found << 1) >> 1;
}

/// By their bits, so that both hold with -ffast-math.
template <class T>
constexpr bool is_finite(T x) {
  return magnitude_bits(x) < magnitude_bits(infinity<T>);
}
template <class T>
constexpr bool is_nan(T x) {
  return magnitude_bits(x) > magnitude_bits(infinity<T>);
}

/// The k of 2ᵏ ≤ |x| < 2ᵏ⁺¹, of a finite x.
template <class T>
constexpr int exponent_of(T x) {
  constexpr bool is_short = std::is_same_v<T, float>;
  constexpr int digits = is_short ? 23 : 52, bias = is_short ? 127 : 1023, size = is_short ? 32 : 64;
  const auto magnitude = magnitude_bits(x);
  if (magnitude == 0) return exponent_of_zero;
  const int biased = static_cast<int>(magnitude >> digits);
  return biased > 0 ? biased - bias : size - digits - bias - std::countl_zero(magnitude);
}

/// 2ᵏ, where it is a normal number.
template <class T>
constexpr T power_of_two(int k) {
  if constexpr (std::is_same_v<T, float>)
    return std::bit_cast<float>(static_cast<std::uint32_t>(k + 127) << 23);
  else
    return static_cast<T>(elementary::detail::power_of_two(k));
}

/// x 2ᵏ; infinite, without arithmetic that overflows, where it is too large.
template <class T>
constexpr T times_power_of_two(T x, int k) {
  constexpr int too_large = std::numeric_limits<T>::max_exponent, most = too_large - 2;
  if (exponent_of(x) + k >= too_large) return x < 0 ? -infinity<T> : infinity<T>;
  if (is_exponent_of_zero(exponent_of(x) + k)) return 0;
  for (; k > most; k -= most) x *= power_of_two<T>(most);
  for (; k < -most; k += most) x *= power_of_two<T>(-most);
  return x * power_of_two<T>(k);
}

} // namespace kanexpr::numeric
