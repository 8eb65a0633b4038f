#pragma once

#include <kanexpr/numeric/sine_and_cosine.hpp>

/// Sines and cosines of several of the compiler's vectors at once, with one branch for all of them.
namespace kanexpr::numeric {

namespace detail {

/// The highest bit of a lane is set where its angle is out of reach, or no number.
template <class T>
[[gnu::always_inline]] inline bits_of<T> beyond_reach(const T& angle) {
  const bits_of<T> given = __builtin_bit_cast(bits_of<T>, angle);
  return __builtin_bit_cast(number_bits<T>, number_of<T>(farthest_angle)) - (given << 1 >> 1);
}

/// All lanes, joined by "or".
template <class Bits>
[[gnu::always_inline]] inline auto any_of(const Bits& bits) {
  auto any = bits[0];
  for (std::size_t i = 1; i < lanes<Bits>::count; ++i) any |= bits[i];
  return any;
}

template <std::size_t first, class T, std::size_t... i>
[[gnu::always_inline]] inline auto half_of(const T& whole, std::index_sequence<i...>) {
  return __builtin_shufflevector(whole, whole, (first + i)...);
}

template <class T, class Half, std::size_t... i>
[[gnu::always_inline]] inline T joined(const Half& first, const Half& second, std::index_sequence<i...>) {
  return __builtin_shufflevector(first, second, i...);
}

/// Whether what is computed with has room in the vectors of the processor: angles of single precision are
/// reduced by way of `double`.
template <class T>
inline constexpr bool has_room =
    !std::is_same_v<number_of<T>, float> || lanes<T>::count * sizeof(double) <= widest_vector;

/// In halves, until they have room: else single-precision angles would be reduced one by one.
template <class T>
[[gnu::always_inline]] inline void sine_and_cosine_by_halves(const T& angle, T& sine, T& cosine) {
  if constexpr (constexpr std::size_t count = lanes<T>::count; count == 2 || has_room<T>) {
    sine_and_cosine_within_reach(angle, sine, cosine);
  } else {
    using half = typename vector_of<number_of<T>, count / 2>::type;
    constexpr std::make_index_sequence<count / 2> in_half;
    constexpr std::make_index_sequence<count> in_all;
    half s[2], c[2];
    sine_and_cosine_by_halves<half>(half_of<0>(angle, in_half), s[0], c[0]);
    sine_and_cosine_by_halves<half>(half_of<count / 2>(angle, in_half), s[1], c[1]);
    sine = joined<T>(s[0], s[1], in_all);
    cosine = joined<T>(c[0], c[1], in_all);
  }
}

template <class T, std::size_t count, std::size_t... i>
[[gnu::always_inline]] inline bool sines_and_cosines_of_vectors(const T (&angle)[count], T (&sine)[count],
                                                                T (&cosine)[count],
                                                                std::index_sequence<i...>) {
  (sine_and_cosine_by_halves(angle[i], sine[i], cosine[i]), ...);
  return any_of((beyond_reach(angle[i]) | ...)) >> (8 * sizeof(number_of<T>) - 1) != 0;
}

} // namespace detail

/// Each lane has the bits of `sine_and_cosine` of its angle.
template <class T, std::size_t count>
  requires(detail::lanes<T>::count > 1)
[[gnu::always_inline]] inline void sines_and_cosines(const T (&angle)[count], T (&sine)[count],
                                                     T (&cosine)[count]) noexcept {
  [[maybe_unused]] const bool far =
      detail::sines_and_cosines_of_vectors(angle, sine, cosine, std::make_index_sequence<count>{});
#if !defined(KANEXPR_ANGLES_WITHIN_REACH)
  if (far) [[unlikely]] {
    constexpr std::size_t lanes = detail::lanes<T>::count;
    // Aligned, and with them the stack: clang++ would put vectors across the lines of a cache.
    alignas(T) detail::number_of<T> angles[count][lanes];
    alignas(T) detail::number_of<T> sines[count][lanes];
    alignas(T) detail::number_of<T> cosines[count][lanes];
    std::memcpy(angles, angle, sizeof angles);
    std::memcpy(sines, sine, sizeof angles);
    std::memcpy(cosines, cosine, sizeof angles);
    detail::by_the_library(count * lanes, angles[0], sines[0], cosines[0]);
    std::memcpy(sine, sines, sizeof angles);
    std::memcpy(cosine, cosines, sizeof angles);
  }
#endif
}

} // namespace kanexpr::numeric
