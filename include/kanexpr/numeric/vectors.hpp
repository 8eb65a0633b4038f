#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

/// The compiler's vector types, `typedef double pack __attribute__((vector_size(32)));`, which compilers map
/// to the vector registers of the processor.
namespace kanexpr::numeric {

/// The width in bytes of the vectors used for computation; 0 if none are used. AVX-512 vectors would be
/// slower.
#if defined(__AVX2__)
inline constexpr std::size_t widest_vector = 32;
#elif defined(__SSE2__) || defined(__aarch64__)
inline constexpr std::size_t widest_vector = 16;
#else
inline constexpr std::size_t widest_vector = 0;
#endif

namespace detail {

template <class Number, std::size_t count>
struct vector_of {
  typedef Number type __attribute__((vector_size(count * sizeof(Number))));
};
template <class Number>
struct vector_of<Number, 1> {
  using type = Number;
};

/// The lanes of T, which is a number or one of the compiler's vectors.
template <class Value>
struct lanes {
  using number = Value;
  static constexpr std::size_t count = 1;
};
template <class Value>
  requires requires(const Value v) { v[0]; }
struct lanes<Value> {
  using number = std::remove_cvref_t<decltype(std::declval<const Value&>()[0])>;
  static constexpr std::size_t count = sizeof(Value) / sizeof(number);
};
template <class Value>
using number_of = typename lanes<Value>::number;
/// A vector with the same number of lanes and a different scalar type.
template <class Value, class Number>
using lanes_as = typename vector_of<Number, lanes<Value>::count>::type;
template <class Value>
using number_bits = std::conditional_t<sizeof(number_of<Value>) == 8, std::uint64_t, std::uint32_t>;
template <class Value>
using bits_of = lanes_as<Value, number_bits<Value>>;

template <class To, class From>
[[gnu::always_inline]] constexpr To converted(const From& v) {
  if constexpr (lanes<From>::count == 1) {
    return static_cast<To>(v);
  } else {
#if defined(__AVX__) && !defined(__clang__) // g++ would need two more instructions and a register
    if constexpr (std::is_same_v<number_of<From>, float> && sizeof(From) == 16 && sizeof(To) == 32)
      return __builtin_ia32_cvtps2pd256(v);
    else
#endif
      return __builtin_convertvector(v, To);
  }
}

template <class Bits, std::size_t... index>
[[gnu::always_inline]] constexpr auto every_other(const Bits& bits, std::index_sequence<index...>) {
  return __builtin_shufflevector(bits, bits, 2 * index...);
}

/// Returns the lower halves of 64-bit lanes.
template <class Bits>
[[gnu::always_inline]] constexpr lanes_as<Bits, std::uint32_t> lower_halves(const Bits& bits) {
  constexpr std::size_t count = lanes<Bits>::count;
  if constexpr (count == 1 || __BYTE_ORDER__ != __ORDER_LITTLE_ENDIAN__) {
    return converted<lanes_as<Bits, std::uint32_t>>(bits);
  } else {
    using halves = typename vector_of<std::uint32_t, 2 * count>::type;
    return every_other(__builtin_bit_cast(halves, bits), std::make_index_sequence<count>{});
  }
}

#if defined(__AVX__)
inline constexpr std::size_t widest_with_mask = 32;
#elif defined(__SSE2__)
inline constexpr std::size_t widest_with_mask = 16;
#else
inline constexpr std::size_t widest_with_mask = 0;
#endif

/// Returns the highest bits of all lanes as one number.
template <class Bits>
[[gnu::always_inline]] inline int mask_of([[maybe_unused]] const Bits& bits) {
#if defined(__SSE2__)
  constexpr bool is_of_eight = sizeof(number_of<Bits>) == 8;
  if constexpr (sizeof(Bits) == 16 && is_of_eight)
    return __builtin_ia32_movmskpd(__builtin_bit_cast(lanes_as<Bits, double>, bits));
  if constexpr (sizeof(Bits) == 16 && !is_of_eight)
    return __builtin_ia32_movmskps(__builtin_bit_cast(lanes_as<Bits, float>, bits));
#if defined(__AVX__)
  if constexpr (sizeof(Bits) == 32 && is_of_eight)
    return __builtin_ia32_movmskpd256(__builtin_bit_cast(lanes_as<Bits, double>, bits));
  if constexpr (sizeof(Bits) == 32 && !is_of_eight)
    return __builtin_ia32_movmskps256(__builtin_bit_cast(lanes_as<Bits, float>, bits));
#endif
#endif
  return 0;
}

template <class Bits>
[[gnu::always_inline]] constexpr bool is_set_in_a_lane(const Bits& bits);

template <class Bits, std::size_t... index>
[[gnu::always_inline]] constexpr bool is_set_in_a_half(const Bits& bits, std::index_sequence<index...>) {
  return is_set_in_a_lane(__builtin_shufflevector(bits, bits, index...) |
                          __builtin_shufflevector(bits, bits, (sizeof...(index) + index)...));
}

/// Whether the highest bit is set in any lane; comparisons and negative signs set it.
template <class Bits>
[[gnu::always_inline]] constexpr bool is_set_in_a_lane(const Bits& bits) {
  constexpr std::size_t count = lanes<Bits>::count;
  if constexpr (count > 1 && sizeof(Bits) > widest_with_mask && widest_with_mask > 0)
    return is_set_in_a_half(bits, std::make_index_sequence<count / 2>{});
  if constexpr (count > 1 && sizeof(Bits) >= 16 && sizeof(Bits) <= widest_with_mask)
    if (!std::is_constant_evaluated()) return mask_of(bits) != 0;
  number_bits<Bits> any{};
  if constexpr (count == 1)
    any = static_cast<number_bits<Bits>>(bits);
  else
    for (std::size_t i = 0; i < count; ++i) any |= static_cast<number_bits<Bits>>(bits[i]);
  return any >> (8 * sizeof any - 1) != 0;
}

} // namespace detail

} // namespace kanexpr::numeric
