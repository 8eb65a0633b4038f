#pragma once

#include <kanexpr/base/equal.hpp>

#include <bit>
#include <concepts>
#include <cstdint>
#include <type_traits>

/// The scalar types for which selection uses masks, because compilers turn conditional expressions into
/// branches.
namespace kanexpr::numeric {

template <class Number>
concept selected_by_masks = std::same_as<Number, double> || std::same_as<Number, float>;

/// Returns x if c is positive, otherwise 0; NaN if c is NaN.
template <selected_by_masks Number>
[[gnu::always_inline]] constexpr Number where_positive(Number c, Number x) noexcept {
  using bits = std::conditional_t<sizeof(Number) == 8, std::uint64_t, std::uint32_t>;
  const bits is_positive = bits{0} - static_cast<bits>(Number(0) < c),
             is_negative = bits{0} - static_cast<bits>(c < Number(0));
  return std::bit_cast<Number>((std::bit_cast<bits>(x) & is_positive) |
                               (std::bit_cast<bits>(c) & ~(is_positive | is_negative)));
}

/// Returns 0 if c is positive, otherwise x; NaN if c is NaN.
template <selected_by_masks Number>
[[gnu::always_inline]] constexpr Number where_not_positive(Number c, Number x) noexcept {
  using bits = std::conditional_t<sizeof(Number) == 8, std::uint64_t, std::uint32_t>;
  const bits is_positive = bits{0} - static_cast<bits>(Number(0) < c),
             is_other = bits{0} - static_cast<bits>(c <= Number(0));
  return std::bit_cast<Number>((std::bit_cast<bits>(x) & is_other) |
                               (std::bit_cast<bits>(c) & ~(is_positive | is_other)));
}

/// Returns x if c is a number, otherwise c.
template <selected_by_masks Number>
[[gnu::always_inline]] constexpr Number where_number(Number c, Number x) noexcept {
  using bits = std::conditional_t<sizeof(Number) == 8, std::uint64_t, std::uint32_t>;
  const bits is_one = bits{0} - static_cast<bits>(base::is_number(c));
  return std::bit_cast<Number>((std::bit_cast<bits>(x) & is_one) | (std::bit_cast<bits>(c) & ~is_one));
}

} // namespace kanexpr::numeric
