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

template <class T, std::size_t count, std::size_t... i>
[[gnu::always_inline]] inline bool sines_and_cosines_of_vectors(const T (&angle)[count], T (&sine)[count],
                                                                T (&cosine)[count],
                                                                std::index_sequence<i...>) {
  (sine_and_cosine_within_reach(angle[i], sine[i], cosine[i]), ...);
  return is_set_in_a_lane((beyond_reach(angle[i]) | ...));
}

} // namespace detail

/// Each lane has the bits of `sine_and_cosine` of its angle.
template <class T, std::size_t count>
  requires(detail::lanes<T>::count > 1)
[[gnu::always_inline]] inline void sines_and_cosines(const T (&angle)[count], T (&sine)[count],
                                                     T (&cosine)[count]) noexcept {
  [[maybe_unused]] const bool is_far =
      detail::sines_and_cosines_of_vectors(angle, sine, cosine, std::make_index_sequence<count>{});
#if !defined(KANEXPR_ANGLES_WITHIN_REACH)
  if (is_far) [[unlikely]] {
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
