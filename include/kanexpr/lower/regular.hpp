#pragma once

#include <kanexpr/lower/scalar_math.hpp>

namespace kanexpr::lower {

/// Whether a measure is more than `least` of its scale, whatever their signs are. One that is infinite or no
/// number is not called singular: the results that depend on it are not finite, and that is looked at last.
template <class T>
[[gnu::always_inline]] inline bool is_regular(const T& measure, const T& scale, double least) {
  using math = scalar_math<T>;
  const T size = math::template by_name<symbolic::operation::abs>(measure);
  const T bound = T(math::from(least) * math::template by_name<symbolic::operation::abs>(scale));
  if constexpr (std::is_arithmetic_v<T>)
    return !(size - bound <= 0); // beside infinity, infinity leaves no number
  else if constexpr (requires { math::is_in_no_lane(size <= bound); })
    return math::is_in_no_lane(size - bound <= T{}); // lanes know nothing of each other
  else
    return math::exceeds(size, bound) || !math::is_finite(measure);
}

/// What a status asks of a measure: to be finite, or to be regular beside its scale.
template <bool finiteness, class T>
[[gnu::always_inline]] inline bool passes(const T& measure, [[maybe_unused]] const T& scale,
                                          [[maybe_unused]] double least) {
  if constexpr (finiteness)
    return scalar_math<T>::is_finite(measure);
  else
    return is_regular<T>(measure, scale, least);
}

} // namespace kanexpr::lower
