#pragma once

#include <kanexpr/describe/operand.hpp>
#include <kanexpr/symbolic/graph/composition.hpp>

/// Functions of several expressions that are defined in terms of other functions. The model reader
/// checks the number of arguments and that they are scalars.
namespace kanexpr {

namespace describe {

/// Several operands, at least one of which is an expression.
template <class... Operands>
concept any_of_a_model = (written<Operands> && ...) && (expression_of_a_model<Operands> || ...);

template <class... Operands>
constexpr auto composed(symbolic::composition f, const Operands&... x) {
  token last = with(token_kind::composed);
  last.index = static_cast<int>(f);
  last.number = symbolic::exactly(sizeof...(Operands));
  constexpr bool has_equation = ((shape_of_operand<Operands> == shape::equation) || ...);
  return joined<shape::scalar>(has_equation ? misused(misuse::inner_equation) : last, operand(x)...);
}

template <class... Operands>
constexpr auto composed_with_zeros(symbolic::composition f, const Operands&... x) {
  return composed(f, operand_or_zero(x)...);
}

/// The type of tabulated<...> and periodic<...>, callable with an expression.
template <symbolic::composition is, auto... points>
struct table_word {
  template <written Operand>
  constexpr auto operator()(const Operand& x) const {
    return has_no_values ? composed(is, x, points...) : composed(is, x, with_zeros(points)...);
  }

private:
  static constexpr bool has_no_values = [] {
    const bool zero[]{false, is_whole_zero(points)...};
    bool all = true;
    for (std::size_t i = 2; i < sizeof(zero); i += 2) all = all && zero[i];
    return all;
  }();
};

} // namespace describe

#define KANEXPR_COMPOSED_FUNCTION(name, form)                                                                \
  template <class... Operands>                                                                               \
    requires describe::any_of_a_model<Operands...>                                                           \
  constexpr auto(name)(const Operands&... x) {                                                               \
    return describe::form(symbolic::composition::name, x...);                                                \
  }

/// The hypotenuse √(x² + y²) of two scalars, `hypot(x, y)`. The squares overflow beyond 1e154, or 1e19 in
/// float.
KANEXPR_COMPOSED_FUNCTION(hypot, composed)
/// Selects a if the condition is positive and b otherwise: `if_positive(condition, a, b)`.
KANEXPR_COMPOSED_FUNCTION(if_positive, composed_with_zeros)
/// The smaller of two scalars, `min(a, b)`: `if_positive(b - a, a, b)`; NaN if either is NaN.
KANEXPR_COMPOSED_FUNCTION(min, composed_with_zeros)
/// The larger of two scalars, `max(a, b)`: `if_positive(a - b, a, b)`; NaN if either is NaN.
KANEXPR_COMPOSED_FUNCTION(max, composed_with_zeros)
/// |x| rounded within about `width` of 0, `smooth_abs(x, width)`: x tanh(x/width).
KANEXPR_COMPOSED_FUNCTION(smooth_abs, composed)
/// max(x, 0) rounded within about `width` of 0, `softplus(x, width)`: width ln(1 + e^(x/width)).
KANEXPR_COMPOSED_FUNCTION(softplus, composed)
/// A step that rises from 0 at x = `from` to 1 at x = `to` with continuous second derivatives:
/// `smooth_step(x, from, to)`.
KANEXPR_COMPOSED_FUNCTION(smooth_step, composed_with_zeros)
#undef KANEXPR_COMPOSED_FUNCTION

/// The scalar x limited to [least, most], `clamp(x, least, most)`; `most` if `least` exceeds it.
template <class... Operands>
  requires describe::any_of_a_model<Operands...>
constexpr auto clamp(const Operands&... x) {
  const bool is_of_zeros = ((!describe::plain_number<Operands> || describe::is_whole_zero(x)) && ...);
  return is_of_zeros ? describe::composed(symbolic::composition::clamp, x...)
                     : describe::composed_with_zeros(symbolic::composition::clamp, x...);
}

/// Monotone cubic interpolation of points, constant beyond the first and the last: `tabulated<x0, y0, x1, y1,
/// x2, y2>(q)`.
template <auto... points>
inline constexpr describe::table_word<symbolic::composition::tabulated, points...> tabulated{};

/// Monotone cubic interpolation of a periodic curve, whose last value must equal the first: `periodic<x0, y0,
/// x1, y1, x2, y0>(q)`.
template <auto... points>
inline constexpr describe::table_word<symbolic::composition::periodic, points...> periodic{};

} // namespace kanexpr
