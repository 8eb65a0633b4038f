#pragma once

#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/function_table.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/limits/coefficient.hpp>

#include <optional>

/// Functions of coefficients; they return nothing if the value of a number is not real or not finite.
namespace kanexpr::symbolic::limits {

namespace detail {

inline number function_of(operation op, const number& n) {
  if (op == operation::sqrt) return root_of(n);
  if (op == operation::abs) return n.negative() ? -n : n;
  return real(value_of(op, n.value(), 0));
}

/// Whether a function of an exact number has an exact value.
inline bool stays_exact(operation op, const number& n, const number& f) {
  if (op == operation::abs || op == operation::sign) return true;
  if (op == operation::sqrt) return f.exact() && f * f == n;
  if (op == operation::cbrt) return f.exact() && f * f * f == n;
  const int at = properties_of(op).exact_at;
  return at != function_properties::nowhere && n == exactly(at);
}

inline number integer_power(const number& base, std::int64_t exponent) {
  if (exponent < 0) return exactly(1) / integer_power(base, -exponent);
  number power = exactly(1);
  for (std::int64_t i = 0; i < exponent; ++i) power = power * base;
  return power;
}

} // namespace detail

inline std::optional<coefficient> apply(operation op, const coefficient& a) {
  const generic_values at = apply(op, a.at(), {});
  if (!a.is_number())
    return coefficient(expression{a.owner(), apply(a.owner(), op, a.in(a.owner()).node())}, at);
  const number f = detail::function_of(op, a.value());
  if (!numeric::is_finite(f.value())) return std::nullopt;
  return coefficient(f, a.is_exact() && detail::stays_exact(op, a.value(), f), at);
}

inline std::optional<coefficient> apply(operation op, const coefficient& a, const coefficient& b) {
  const generic_values at = apply(op, a.at(), b.at());
  if (a.is_number() && b.is_number()) {
    const binary_function_properties& f = binary_properties_of(op);
    const double x = a.value().value(), y = b.value().value(), value = f.value(x, y);
    if (!numeric::is_finite(value)) return std::nullopt;
    return coefficient(real(value), a.is_exact() && b.is_exact() && f.is_exact_at(x, y), at);
  }
  graph& g = a.is_number() ? b.owner() : a.owner();
  const expression first = a.in(g);
  return coefficient(apply(op, first, b.in(g)), at);
}

/// Requires that the condition is an expression.
inline coefficient selected(operation op, const coefficient& condition, const coefficient& x) {
  graph& g = condition.owner();
  const expression on = condition.in(g);
  return {selected(op, on, x.in(g)), apply(op, condition.at(), x.at())};
}

/// Requires a nonzero base.
inline std::optional<coefficient> power(const coefficient& base, const coefficient& exponent) {
  const generic_values at = apply(operation::power, base.at(), exponent.at());
  if (base.is_number() && exponent.is_number()) {
    constexpr std::int64_t largest = 64;
    const number n = exponent.value();
    if (n.integer() && n.numerator <= largest && n.numerator >= -largest)
      return coefficient(detail::integer_power(base.value(), n.numerator), base.is_exact(), at);
    const double value = numeric::elementary::pow(base.value().value(), n.value());
    if (!numeric::is_finite(value)) return std::nullopt;
    return coefficient(real(value), false, at);
  }
  if (base.is_number() && base.value().negative()) return std::nullopt;
  graph& g = base.is_number() ? exponent.owner() : base.owner();
  const expression of = base.in(g);
  return coefficient(power(of, exponent.in(g)), at);
}

} // namespace kanexpr::symbolic::limits
