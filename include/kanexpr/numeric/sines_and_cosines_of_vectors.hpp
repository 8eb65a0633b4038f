#pragma once

#include <kanexpr/numeric/sine_and_cosine.hpp>

#include <utility>

/// Sines and cosines of several of the compiler's vectors, with a single branch for all of them.
namespace kanexpr::numeric {

namespace detail {

/// Sets the highest bit of each lane whose angle is out of range or NaN.
template <class Value>
[[gnu::always_inline]] inline bits_of<Value> out_of_range_bits(const Value& angle) {
  const bits_of<Value> given = __builtin_bit_cast(bits_of<Value>, angle);
  return __builtin_bit_cast(number_bits<Value>, number_of<Value>(farthest_angle)) - (given << 1 >> 1);
}

template <class Value, std::size_t count, std::size_t... index>
[[gnu::always_inline]] inline bool sines_and_cosines_of_vectors(const Value (&angle)[count],
                                                                Value (&sine)[count], Value (&cosine)[count],
                                                                std::index_sequence<index...>) {
  (sine_and_cosine_in_range(angle[index], sine[index], cosine[index]), ...);
  return is_set_in_a_lane((out_of_range_bits(angle[index]) | ...));
}

} // namespace detail

/// Computes sines and cosines; each lane has the same bits as `sine_and_cosine` of its angle.
template <class Value, std::size_t count>
  requires(detail::lanes<Value>::count > 1)
[[gnu::always_inline]] inline void sines_and_cosines(const Value (&angle)[count], Value (&sine)[count],
                                                     Value (&cosine)[count]) noexcept {
  [[maybe_unused]] const bool is_far =
      detail::sines_and_cosines_of_vectors(angle, sine, cosine, std::make_index_sequence<count>{});
#if !defined(KANEXPR_ANGLES_WITHIN_REACH)
  if (is_far) [[unlikely]] {
    constexpr std::size_t lanes = detail::lanes<Value>::count;
    // The alignment also aligns the stack; otherwise clang++ would place vectors across cache lines.
    alignas(Value) detail::number_of<Value> angles[count][lanes];
    alignas(Value) detail::number_of<Value> sines[count][lanes];
    alignas(Value) detail::number_of<Value> cosines[count][lanes];
    std::memcpy(angles, angle, sizeof angles);
    std::memcpy(sines, sine, sizeof angles);
    std::memcpy(cosines, cosine, sizeof angles);
    detail::by_c_library(count * lanes, angles[0], sines[0], cosines[0]);
    std::memcpy(sine, sines, sizeof angles);
    std::memcpy(cosine, cosines, sizeof angles);
  }
#endif
}

} // namespace kanexpr::numeric
