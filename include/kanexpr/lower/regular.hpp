#pragma once

#include <kanexpr/lower/scalar_math.hpp>

namespace kanexpr::lower {

/// Whether a measure is more than `least` of its scale, whatever their signs are; what is no number is not.
template <class T>
[[gnu::always_inline]] inline bool is_regular(const T& measure, const T& scale, double least) {
  using math = scalar_math<T>;
  return math::exceeds(math::template by_name<symbolic::operation::abs>(measure),
                       T(math::from(least) * math::template by_name<symbolic::operation::abs>(scale)));
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
