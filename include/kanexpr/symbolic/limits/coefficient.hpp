#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/functions.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/limits/generic_values.hpp>

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
    if (!is_exact_ && at_.vanish()) *this = {};
  }
  coefficient(expression e, const generic_values& at) : at_(at) {
    if (e.is_constant())
      *this = coefficient(e.owner().number_at(e.node()), at.is_number() && base::equal(at[0].error, 0.0), at);
    else if (at.vanish())
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

/// A quotient of expressions with its numerical factors combined in front, so that the factors from a
/// direction cancel.
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

} // namespace kanexpr::symbolic::limits
