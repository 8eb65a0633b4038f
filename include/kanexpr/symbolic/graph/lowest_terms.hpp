#pragma once

#include <kanexpr/symbolic/graph/build.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/monomials.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

namespace kanexpr::symbolic {

namespace detail {

/// Multiplies the factors of a product, or a single factor, into a monomial; returns false if they do not
/// fit.
constexpr bool take_factors(const graph& g, int id, monomial& into) {
  const node& n = g[id];
  if (n.op == operation::multiply) return take_factors(g, n.a, into) && take_factors(g, n.b, into);
  if (n.op == operation::constant) {
    into.coefficient = into.coefficient * g.number_at(id);
    return true;
  }
  if (n.op != operation::negate) return into.multiply_by(id, 1);
  into.coefficient = -into.coefficient;
  return take_factors(g, n.a, into);
}

constexpr int product_of(graph& g, const monomial& m) {
  int product = graph::one;
  for (int i = 0; i < m.count; ++i)
    for (int k = 0; k < m.powers[i].exponent; ++k) product = multiply(g, product, m.powers[i].factor);
  return product;
}

} // namespace detail

/// A quotient of products with common factors canceled, such as the mass in −m g l sin(q)/(m l²).
constexpr int divide_in_lowest_terms(graph& g, int a, int b) {
  if (g.is_constant(a) || g.is_constant(b)) return divide(g, a, b);
  monomial above, below;
  if (!detail::take_factors(g, a, above) || !detail::take_factors(g, b, below)) return divide(g, a, b);
  bool any = false;
  for (int i = 0; i < above.count; ++i) {
    const monomial::power taken = above.powers[i];
    const int under = below.exponent_of(taken.factor),
              shared = taken.exponent < under ? taken.exponent : under;
    if (shared == 0) continue;
    any = true;
    below.multiply_by(taken.factor, -shared);
    above.multiply_by(taken.factor, -shared);
    if (shared == taken.exponent) --i; // removed
  }
  if (!any) return divide(g, a, b);
  const int coefficient = g.constant(above.coefficient / below.coefficient);
  const int numerator = multiply(g, coefficient, detail::product_of(g, above));
  return divide(g, numerator, detail::product_of(g, below));
}

} // namespace kanexpr::symbolic
