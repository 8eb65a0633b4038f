#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/function_table.hpp>
#include <kanexpr/symbolic/graph/functions.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/limits/generic_values.hpp>

#include <optional>

namespace kanexpr::symbolic::limits {

/// A coefficient of a series: a number, exact if possible, or an expression. It counts as zero if it vanishes
/// at generic values of its symbols or within the rounding bound.
class coefficient {
public:
  coefficient() = default;
  explicit coefficient(const number& n) : number_(n), at_(bounded::of(n)), is_exact_(n.exact()) {}
  explicit coefficient(int n) : coefficient(exactly(n)) {}
  coefficient(const number& n, bool is_exact, const generic_values& at)
      : number_(n), at_(at), is_exact_(is_exact && n.exact()) {
    if (!is_exact_ && at_.vanishes_everywhere()) *this = {};
  }
  coefficient(expression e, const generic_values& at) : at_(at) {
    if (e.is_constant())
      *this = coefficient(e.owner().number_at(e.node()), at.is_number() && base::equal(at[0].error, 0.0), at);
    else if (at.vanishes_everywhere())
      *this = {};
    else
      expression_ = e, is_exact_ = false, is_number_ = false;
  }

  bool is_number() const { return is_number_; }
  bool is_exact() const { return is_exact_; } ///< an exact number
  bool is_zero() const { return is_number_ && base::equal(number_.value(), 0.0); }
  const number& value() const { return number_; }
  const generic_values& at() const { return at_; }
  graph& owner() const { return expression_.owner(); } ///< requires an expression
  expression in(graph& g) const { return is_number_ ? constant(g, number_) : expression_; }

private:
  number number_{};
  expression expression_{};
  generic_values at_{};
  bool is_number_ = true;
  bool is_exact_ = true;
};

namespace detail {

/// Requires an arithmetic operation and a nonzero divisor.
inline number arithmetic(operation op, const number& a, const number& b) {
  if (op == operation::add) return a + b;
  if (op == operation::subtract) return a - b;
  return op == operation::multiply ? a * b : a / b;
}

/// A quotient of expressions with its numerical factors combined in front, so that the factors that come from
/// a direction cancel.
inline int quotient(graph& g, int a, int b) {
  const bool is_negative = (g[a].op == operation::negate) != (g[b].op == operation::negate);
  struct scaled {
    number coefficient;
    int rest;
  };
  const auto split = [&g](int id) -> scaled {
    if (g[id].op == operation::negate) id = g[id].a;
    const node& n = g[id];
    if (n.op == operation::multiply && g.is_constant(n.a)) return {g.number_at(n.a), n.b};
    return {exactly(1), id};
  };
  const scaled above = split(a), below = split(b);
  if (g.is_constant(b)) return divide(g, a, b);
  const int rest = divide(g, g.is_constant(a) ? a : above.rest, below.rest);
  const number front = (g.is_constant(a) ? exactly(1) : above.coefficient) / below.coefficient;
  const int product = multiply(g, g.constant(front), rest);
  return is_negative ? negate(g, product) : product;
}

inline coefficient combined(operation op, const coefficient& a, const coefficient& b) {
  const generic_values at = apply(op, a.at(), b.at());
  if (a.is_number() && b.is_number())
    return {arithmetic(op, a.value(), b.value()), a.is_exact() && b.is_exact(), at};
  graph& g = a.is_number() ? b.owner() : a.owner();
  const int x = a.in(g).node(), y = b.in(g).node();
  return {expression{g, op == operation::divide ? quotient(g, x, y) : build(g, op, x, y)}, at};
}

} // namespace detail

inline coefficient operator+(const coefficient& a, const coefficient& b) {
  if (a.is_zero() || b.is_zero()) return a.is_zero() ? b : a;
  return detail::combined(operation::add, a, b);
}
inline coefficient operator-(const coefficient& a, const coefficient& b) {
  if (b.is_zero()) return a;
  return detail::combined(operation::subtract, a, b);
}
inline coefficient operator*(const coefficient& a, const coefficient& b) {
  if (a.is_zero() || b.is_zero()) return {};
  return detail::combined(operation::multiply, a, b);
}
/// Requires that `b` is not zero.
inline coefficient operator/(const coefficient& a, const coefficient& b) {
  if (a.is_zero()) return {};
  return detail::combined(operation::divide, a, b);
}
inline coefficient operator-(const coefficient& a) { return coefficient{} - a; }

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

/// A function of coefficients, or nothing if the value of a number is not real or not finite.
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
