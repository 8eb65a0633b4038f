#pragma once

#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/functions.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>
#include <kanexpr/symbolic/limits/function_series.hpp>

#include <initializer_list>
#include <optional>
#include <vector>

namespace kanexpr::symbolic::limits {

/// Whether the leading term decides the result of an operation but vanishes for some values of the symbols.
inline bool is_piecewise(operation op, const series& a, const series& b) {
  const auto is_unsure = [](const series& s) { return s.has_terms() && s.lead().at().vanishes_at_some(); };
  if (op == operation::divide) return is_unsure(b);
  if (is_binary_function(op)) return is_unsure(a) || is_unsure(b);
  if (is_selection(op)) return is_unsure(a);
  return (op == operation::power || op == operation::sqrt || op == operation::log || op == operation::abs ||
          op == operation::sign || op == operation::cbrt) &&
         is_unsure(a);
}

inline expansion apply(operation op, const series& a, const series& b);

/// Evaluates an expression whose symbols are replaced by series, which are indexed by symbol position.
inline expansion series_of(expression e, std::initializer_list<const series*> symbols) {
  const graph& g = e.owner();
  std::vector<expansion> at;
  for (int id = 0; id <= e.node(); ++id) {
    const node& n = g[id];
    if (n.op == operation::constant)
      at.emplace_back(series(coefficient(g.number_at(id))));
    else if (n.op == operation::symbol)
      at.emplace_back(*symbols.begin()[g.symbol_at(id).position]);
    else {
      const expansion &a = at[static_cast<std::size_t>(n.a)], &b = at[static_cast<std::size_t>(n.b)];
      at.push_back(!a ? a : !b ? b : apply(n.op, *a, *b));
    }
  }
  return at[static_cast<std::size_t>(e.node())];
}

/// The derivative of a function of one argument at s, where its value is f.
inline expansion slope_of(operation op, const series& s, const series& f) {
  graph g;
  const expression x = variable(g, {symbol_kind::parameter, "x", 0}),
                   y = variable(g, {symbol_kind::parameter, "f", 1});
  return series_of(symbolic::slope_of(op, x, y), {&s, &f});
}

/// A function that is smooth at s_0, from f' = slope(s, f) s': each known order of f yields the next.
inline expansion smooth(operation op, const series& s) {
  if (const obstacle reason = entire_function_obstacle(s); reason != obstacle::none) return reason;
  const std::optional<coefficient> first = apply(op, s[0]);
  if (!first || s.is_constant()) return detail::constant_or(first, obstacle::not_real);
  series f(0, {*first}, 1, s.max_order());
  for (int k = 1; k < s.computed_end(); ++k) {
    const expansion slope = slope_of(op, s, f);
    if (!slope) return slope;
    f = integral(*slope * derivative(s), *first);
  }
  return f;
}

/// A function of two arguments that is smooth at (a_0, b_0), in the same way.
inline expansion smooth(operation op, const series& a, const series& b) {
  for (const series* each : {&a, &b})
    if (const obstacle reason = entire_function_obstacle(*each); reason != obstacle::none) return reason;
  const std::optional<coefficient> first = apply(op, a[0], b[0]);
  if (!first || (a.is_constant() && b.is_constant())) return detail::constant_or(first, obstacle::not_real);
  graph g;
  const expression x = variable(g, {symbol_kind::parameter, "x", 0}),
                   y = variable(g, {symbol_kind::parameter, "y", 1}),
                   value = variable(g, {symbol_kind::parameter, "f", 2});
  const binary_slopes<expression> by = binary_slopes_of(op, x, y, value);
  series f(0, {*first}, 1, a.max_order());
  for (int k = 1; k < (std::min)(a.computed_end(), b.computed_end()); ++k) {
    const expansion by_a = series_of(by.by_a, {&a, &b, &f}), by_b = series_of(by.by_b, {&a, &b, &f});
    if (!by_a || !by_b) return by_a ? by_b : by_a;
    f = integral(*by_a * derivative(a) + *by_b * derivative(b), *first);
  }
  return f;
}

/// A function of one argument. Functions with poles, end points or corners need more than their derivative
/// and are handled separately.
inline expansion function_of(operation op, const series& s) {
  if (op == operation::sqrt) return sqrt(s);
  if (op == operation::sin || op == operation::cos || op == operation::sinh || op == operation::cosh)
    return sine(s, op);
  if (op == operation::tan) return tan(s);
  if (op == operation::asin || op == operation::acos) return arcsine(s, op);
  if (op == operation::atan) return atan(s);
  if (op == operation::log) return log(s);
  if (op == operation::abs) return magnitude(s);
  if (op == operation::sign) return sign(s);
  if (op == operation::cbrt) return cbrt(s);
  if (op == operation::wrap_to_pi) return wrap_to_pi(s);
  return smooth(op, s);
}

/// An operation other than a linear system.
inline expansion apply(operation op, const series& a, const series& b) {
  if (is_piecewise(op, a, b)) return obstacle::piecewise;
  switch (form_of(op)) {
  case form::negate: return -a;
  case form::add: return a + b;
  case form::subtract: return a - b;
  case form::multiply: return a * b;
  case form::divide: return quotient(a, b);
  case form::power: {
    if (b.is_constant()) return power(a, b[0]);
    const expansion logarithm = log(a);
    return logarithm ? smooth(operation::exp, b * *logarithm) : logarithm;
  }
  case form::function: return function_of(op, a);
  case form::binary_function: return op == operation::atan2 ? atan2(a, b) : smooth(op, a, b);
  case form::selection: return selected(op, a, b);
  case form::leaf:
  case form::list_operation: break; // expanded by the graph traversal
  }
  return obstacle::truncated;
}

} // namespace kanexpr::symbolic::limits
