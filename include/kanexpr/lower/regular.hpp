#pragma once

#include <kanexpr/lower/scalar_math.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

namespace kanexpr::lower {

/// Whether a measure exceeds `least` times its scale, regardless of their signs. An infinite or NaN measure
/// is not reported as singular: the results that depend on it are not finite, and this is checked last.
template <class Number>
[[gnu::always_inline]] inline bool is_regular(const Number& measure, const Number& scale, double least) {
  using math = scalar_math<Number>;
  const Number size = math::template by_name<symbolic::operation::abs>(measure);
  const Number bound = Number(math::from(least) * math::template by_name<symbolic::operation::abs>(scale));
  if constexpr (std::is_arithmetic_v<Number>)
    return !(size - bound <= 0); // infinity minus infinity is NaN
  else if constexpr (requires { math::is_in_no_lane(size <= bound); })
    return math::is_in_no_lane(size - bound <= Number{}); // lanes are independent of each other
  else
    return math::exceeds(size, bound) || !math::is_finite(measure);
}

/// Whether a measure meets the condition of a status: that it is finite, or that it is regular relative to
/// its scale.
template <bool finiteness, class Number>
[[gnu::always_inline]] inline bool passes(const Number& measure, [[maybe_unused]] const Number& scale,
                                          [[maybe_unused]] double least) {
  if constexpr (finiteness)
    return scalar_math<Number>::is_finite(measure);
  else
    return is_regular<Number>(measure, scale, least);
}

} // namespace kanexpr::lower
