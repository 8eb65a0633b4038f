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

} // namespace kanexpr::lower
