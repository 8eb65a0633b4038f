#pragma once

#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/function_table.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/polynomials/polynomial.hpp>
#include <kanexpr/symbolic/printing/term.hpp>

#include <map>
#include <utility>
#include <vector>

/// Converts between expressions and polynomials in nodes of a graph. The order of construction follows from
/// node numbers, so equal polynomials become the same node.
namespace kanexpr::symbolic::algebra {

using namespace polynomials;
using polynomials::monomial; // not the graph's

using real_polynomial = polynomial<rational>;

/// A node as a polynomial: the node itself to the first power, or the negative of its operand if it is a
/// negation.
template <class Coefficient>
polynomial<Coefficient> atom(expression e) {
  const graph& g = e.owner();
  const node& n = g[e.node()];
  if (n.op == operation::negate) return -atom<Coefficient>(expression(e.owner(), n.a));
  if (n.op == operation::constant) {
    const number& value = g.number_at(e.node());
    if (value.exact() || numeric::elementary::detail::is_finite(value.real))
      return Coefficient(exact_value(value));
  }
  return {{{e.node(), 1}}, Coefficient(1)};
}

/// Π base^exponent over the factors whose exponents have the given sign (1 or -1).
inline expression one_sided_product(graph& g, const monomial& m, int sign) {
  expression side(g, graph::one);
  for (const factor& f : m)
    if (sign * f.exponent > 0) side *= expression(g, integer_power(g, f.base, sign * f.exponent));
  return side;
}

inline expression to_expression(graph& g, const rational& r) { return constant(g, number_of(r)); }

inline expression to_expression(graph& g, const term<rational>& t) {
  const expression coefficient = to_expression(g, t.coefficient),
                   numerator = coefficient * one_sided_product(g, t.factors, 1);
  return numerator / one_sided_product(g, t.factors, -1);
}

inline expression to_expression(graph& g, const real_polynomial& p) {
  expression sum(g, graph::zero);
  for (const term<rational>& t : p.terms) sum += to_expression(g, t);
  return sum;
}

/// The order of the bases when the product of all of them is written.
inline std::map<int, std::size_t> written_order(graph& g, const real_polynomial& p) {
  monomial all;
  for (const auto& [base, range] : exponent_ranges(p)) all.push_back({base, 1});
  printing::term_reader reader(g);
  std::map<int, std::size_t> order;
  for (const printing::factor& f : reader.terms_of(one_sided_product(g, all, 1).node()).front().factors)
    order.emplace(f.base, order.size());
  return order;
}

/// Whether the first term, in an order by names, is negative; this sign does not depend on node numbers.
inline bool has_negative_leading_term(graph& g, const real_polynomial& p) {
  if (p.size() <= 1) return !p.is_zero() && p.terms.front().coefficient.is_negative();
  const std::map<int, std::size_t> order = written_order(g, p);
  const auto is_before = [&order](const term<rational>& s, const term<rational>& t) {
    const auto written = [&order](const term<rational>& each) {
      std::vector<std::pair<std::size_t, std::int64_t>> factors;
      for (const factor& f : each.factors) {
        const auto place = order.find(f.base);
        factors.emplace_back(place == order.end() ? order.size() : place->second, -f.exponent);
      }
      std::ranges::sort(factors);
      return factors;
    };
    if (s.factors.empty() || t.factors.empty()) return t.factors.empty() && !s.factors.empty();
    return written(s) < written(t);
  };
  return std::ranges::min_element(p.terms, is_before)->coefficient.is_negative();
}

inline bool is_all_negative(const real_polynomial& p) {
  return std::ranges::all_of(p.terms, [](const term<rational>& t) { return t.coefficient.is_negative(); });
}

/// A polynomial divided by powers of other polynomials, ready to be written as an expression.
struct real_fraction {
  real_polynomial numerator;
  std::vector<std::pair<real_polynomial, std::int64_t>> denominator;
};

/// Writes common factors in front; the signs of the sums do not depend on node numbers.
inline expression to_expression(graph& g, const real_fraction& f) {
  if (f.numerator.is_zero()) return {g, graph::zero};
  auto [number, factors, sum] = split_content(f.numerator);
  bool negative = is_all_negative(sum);
  expression divisors(g, graph::one);
  for (const auto& [divisor, exponent] : f.denominator) {
    const auto [own_number, own_factors, rest] = split_content(divisor);
    const bool flipped = has_negative_leading_term(g, rest);
    if (flipped && exponent % 2 != 0) negative = !negative;
    const int factor = to_expression(g, flipped ? -rest : rest).node();
    divisors *= expression(g, integer_power(g, factor, exponent));
    for (std::int64_t i = 0; i < exponent; ++i) number = number / own_number;
    factors = times(factors, own_factors, -exponent);
  }
  const expression terms = to_expression(g, is_all_negative(sum) ? -sum : sum);
  const expression coefficient = to_expression(g, number);
  const expression numerator = coefficient * one_sided_product(g, factors, 1) * terms;
  const expression quotient = numerator / (one_sided_product(g, factors, -1) * divisors);
  return negative ? -quotient : quotient;
}

/// A function argument split into magnitude and sign.
struct unsigned_argument {
  expression magnitude;
  bool negative = false;

  expression value() const { return negative ? -magnitude : magnitude; }
};

/// A function of one or two arguments, with its sign in front.
template <class Coefficient>
polynomial<Coefficient> function_of(operation op, const unsigned_argument& x, const unsigned_argument& y) {
  graph& g = x.magnitude.owner();
  const parity symmetry = is_function(op) ? properties_of(op).symmetry : parity::none;
  if (symmetry == parity::none) {
    const expression first = x.value();
    return atom<Coefficient>({g, build(g, op, first.node(), is_binary(op) ? y.value().node() : 0)});
  }
  const polynomial<Coefficient> f = atom<Coefficient>(apply(op, x.magnitude));
  return symmetry == parity::odd && x.negative ? -f : f;
}

} // namespace kanexpr::symbolic::algebra
