#pragma once

#include <kanexpr/describe/mistaken.hpp>
#include <kanexpr/describe/mixed.hpp>
#include <kanexpr/symbolic/graph/composition.hpp>

/// Functions of several expressions that are defined in terms of other functions. The reader of the model
/// checks that the number of arguments is right and that they are scalars.
namespace kanexpr {

namespace describe {

template <class... Operands>
concept some_of_a_model = (written<Operands> && ...) && (expression_of_a_model<Operands> || ...);

template <class Operand>
inline constexpr int size_of_operand =
    static_cast<int>(sizeof(operand(std::declval<const Operand&>()).tokens) / sizeof(token));

template <class... Operands>
constexpr auto composed(symbolic::composition f, const Operands&... x) {
  scalar<(size_of_operand<Operands> + ... + 1)> all{};
  int place = 0;
  const auto append = [&](const auto& given) {
    for (const token& each : given.tokens) all.tokens[place++] = each;
  };
  (append(operand(x)), ...);
  token& last = all.tokens[place];
  last = (equates<Operands, Operands> || ...) ? misused(misuse::inner_equation) : with(token_kind::composed);
  if (last.what == token_kind::composed) {
    last.index = static_cast<int>(f);
    last.number = symbolic::exactly(sizeof...(Operands));
  }
  return all;
}

template <class... Operands>
constexpr auto composed_with_zeros(symbolic::composition f, const Operands&... x) {
  return composed(f, with_zeros(x)...);
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

/// √(x² + y²)
template <class... Operands>
  requires describe::some_of_a_model<Operands...>
constexpr auto hypot(const Operands&... x) {
  return describe::composed(symbolic::composition::hypot, x...);
}

/// `if_positive(condition, a, b)`: a if the condition is positive, otherwise b.
template <class... Operands>
  requires describe::some_of_a_model<Operands...>
constexpr auto if_positive(const Operands&... x) {
  return describe::composed_with_zeros(symbolic::composition::if_positive, x...);
}

template <class... Operands>
  requires describe::some_of_a_model<Operands...>
constexpr auto(min)(const Operands&... x) {
  return describe::composed_with_zeros(symbolic::composition::min, x...);
}
template <class... Operands>
  requires describe::some_of_a_model<Operands...>
constexpr auto(max)(const Operands&... x) {
  return describe::composed_with_zeros(symbolic::composition::max, x...);
}

/// `clamp(x, least, most)`
template <class... Operands>
  requires describe::some_of_a_model<Operands...>
constexpr auto clamp(const Operands&... x) {
  const bool is_of_zeros = ((!describe::plain_number<Operands> || describe::is_whole_zero(x)) && ...);
  return is_of_zeros ? describe::composed(symbolic::composition::clamp, x...)
                     : describe::composed_with_zeros(symbolic::composition::clamp, x...);
}

/// `smooth_abs(x, width)`: x tanh(x/width)
template <class... Operands>
  requires describe::some_of_a_model<Operands...>
constexpr auto smooth_abs(const Operands&... x) {
  return describe::composed(symbolic::composition::smooth_abs, x...);
}
/// `softplus(x, width)`: width ln(1 + e^(x/width))
template <class... Operands>
  requires describe::some_of_a_model<Operands...>
constexpr auto softplus(const Operands&... x) {
  return describe::composed(symbolic::composition::softplus, x...);
}
/// `smooth_step(x, from, to)`: rises from 0 to 1 with continuous second derivatives
template <class... Operands>
  requires describe::some_of_a_model<Operands...>
constexpr auto smooth_step(const Operands&... x) {
  return describe::composed_with_zeros(symbolic::composition::smooth_step, x...);
}

/// A monotone cubic through points, constant beyond them: `tabulated<x0, y0, x1, y1, x2, y2>(q)`.
template <auto... points>
inline constexpr describe::table_word<symbolic::composition::tabulated, points...> tabulated{};

/// The same for a periodic curve, whose last value must equal the first.
template <auto... points>
inline constexpr describe::table_word<symbolic::composition::periodic, points...> periodic{};

} // namespace kanexpr
