#pragma once

#include <kanexpr/numeric/sine_and_cosine.hpp>

#include <bit>
#include <utility>

namespace kanexpr::numeric {

namespace detail {

/// Returns how many of the `left` remaining numbers are processed together: enough to fill a vector register,
/// or nearly so.
template <class Number>
constexpr std::size_t lanes_for(std::size_t left) {
  constexpr std::size_t most = widest_vector / sizeof(Number);
  constexpr std::size_t least = 16 / sizeof(Number);
  if (most < least || left == 1) return 1;
  return (std::min)(most, (std::max)(least, std::bit_ceil(left)));
}

template <class Number, std::size_t first, std::size_t lane, std::size_t count>
[[gnu::always_inline]] inline Number angle_in_lane(const Number (&angle)[count]) {
  if constexpr (first + lane < count)
    return angle[first + lane];
  else
    return 0;
}

template <std::size_t first, class Number, std::size_t count, std::size_t... lane>
[[gnu::always_inline]] inline bool sines_and_cosines_from(const Number (&angle)[count], Number (&sine)[count],
                                                          Number (&cosine)[count],
                                                          std::index_sequence<lane...>) {
  using vector = typename vector_of<Number, sizeof...(lane)>::type;
  const vector all{angle_in_lane<Number, first, lane>(angle)...};
  vector sines, cosines;
  sine_and_cosine_in_range(all, sines, cosines);
  const auto keep = [&]<std::size_t index>() {
    if constexpr (first + index < count) {
      if constexpr (sizeof...(lane) == 1)
        sine[first] = sines, cosine[first] = cosines;
      else
        sine[first + index] = sines[index], cosine[first + index] = cosines[index];
    }
  };
  (keep.template operator()<lane>(), ...);
  bool is_far = is_out_of_range(all);
  constexpr std::size_t next = first + sizeof...(lane);
  if constexpr (next < count)
    is_far |= sines_and_cosines_from<next>(angle, sine, cosine,
                                           std::make_index_sequence<lanes_for<Number>(count - next)>{});
  return is_far;
}

} // namespace detail

/// Computes the sines and the cosines of several angles in radians, using SIMD vectors. Each result has the
/// same bits as `sine_and_cosine` of its angle.
template <class Number, std::size_t count>
[[gnu::always_inline]] inline void sines_and_cosines(const Number (&angle)[count], Number (&sine)[count],
                                                     Number (&cosine)[count]) noexcept {
  [[maybe_unused]] const bool is_far = detail::sines_and_cosines_from<0>(
      angle, sine, cosine, std::make_index_sequence<detail::lanes_for<Number>(count)>{});
#if !defined(KANEXPR_ANGLES_WITHIN_REACH)
  if (is_far) [[unlikely]] {
    Number angles[count], sines[count], cosines[count];
    for (std::size_t i = 0; i < count; ++i) angles[i] = angle[i], sines[i] = sine[i], cosines[i] = cosine[i];
    detail::by_c_library(count, angles, sines, cosines);
    for (std::size_t i = 0; i < count; ++i) sine[i] = sines[i], cosine[i] = cosines[i];
  }
#endif
}

} // namespace kanexpr::numeric
