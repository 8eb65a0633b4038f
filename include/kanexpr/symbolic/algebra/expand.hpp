#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/algebra/expression_reader.hpp>
#include <kanexpr/symbolic/algebra/forms.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

#include <map>
#include <vector>

namespace kanexpr::symbolic {

namespace algebra {

/// Reads expressions as sums of products of powers. Functions are treated as symbols, and a sum in a
/// denominator as one factor.
class expansion_reader : public expression_reader<real_polynomial, expansion_reader> {
public:
  using expression_reader::expression_reader;

  static std::size_t size(const real_polynomial& p) { return p.size(); }
  bool has_minus(const real_polynomial& p) { return has_negative_leading_term(owner(), p); }
  expression written(const real_polynomial& p) { return to_expression(owner(), p); }

  real_polynomial negative(const real_polynomial& a) { return -a; }
  real_polynomial sum(const real_polynomial& a, const real_polynomial& b) { return a + b; }
  real_polynomial product(const real_polynomial& a, const real_polynomial& b) {
    return multiplied(polynomials::product(a, b, left()));
  }
  real_polynomial quotient(const real_polynomial& a, const real_polynomial& b) {
    return b.is_zero() ? over_zero(a) : product(a, inverse(b));
  }
  real_polynomial atomic(int id) { return atom<rational>({owner(), id}); }
  real_polynomial function(operation op, const real_polynomial& a, const real_polynomial& b) {
    const unsigned_argument x = argument(a), y = argument(b);
    const real_polynomial f = function_of<rational>(op, x, y);
    if (op == operation::sqrt && f.size() == 1 && !f.is_constant())
      definitions_[f.terms[0].factors[0].base] = a;
    return f;
  }

private:
  real_polynomial over_zero(const real_polynomial& a) {
    return {{{(to_expression(owner(), a) / expression(owner(), graph::zero)).node(), 1}}, rational(1)};
  }

  real_polynomial inverse(const real_polynomial& p) {
    if (p.size() == 1) return {over({}, p.terms.front().factors), rational(1) / p.terms.front().coefficient};
    auto [number, shared, sum] = split_content(p);
    if (has_negative_leading_term(owner(), p)) number = -number, sum = -sum;
    const int base = to_expression(owner(), sum).node();
    definitions_[base] = sum;
    return {over({}, times(shared, {{base, 1}})), rational(1) / number};
  }

  /// Replaces squares of roots by their radicands, and denominator sums that move to a numerator by their
  /// terms.
  real_polynomial multiplied(const real_polynomial& p) {
    const int base = definitions_.empty() ? none : expandable_base(p);
    if (base == none) return p;
    real_polynomial open, others;
    for (const term<rational>& t : p.terms)
      (is_expandable(base, exponent_of(t.factors, base)) ? open : others).terms.push_back(t);
    real_polynomial sum = multiplied(others);
    for (const auto& [power, rest] : coefficients(open, [base](int b) { return b == base; })) {
      const std::int64_t exponent = power.front().exponent;
      const std::int64_t root = is_root(base) ? exponent % 2 : 0;
      const std::int64_t whole = is_root(base) ? exponent / 2 : exponent;
      const real_polynomial& definition = definitions_.find(base)->second;
      const real_polynomial value =
          raised(whole < 0 ? inverse(definition) : definition, std::abs(whole), left());
      const monomial kept = root == 0 ? monomial{} : monomial{{base, root}};
      sum = sum + multiplied(polynomials::product(scaled(rest, rational(1), kept), value, left()));
      if (!left().allows(sum.size())) return {};
    }
    return sum;
  }

  static constexpr int none = -1;

  int expandable_base(const real_polynomial& p) const {
    for (const term<rational>& t : p.terms)
      for (const factor& f : t.factors)
        if (definitions_.contains(f.base) && is_expandable(f.base, f.exponent)) return f.base;
    return none;
  }
  bool is_root(int base) const { return owner()[base].op == operation::sqrt; }
  bool is_expandable(int base, std::int64_t exponent) const {
    return is_root(base) ? exponent > 1 || exponent < -1 : exponent > 0;
  }

  std::map<int, real_polynomial> definitions_{}; ///< radicands and sums in denominators
};

} // namespace algebra

KANEXPR_ENGINE rewritten expand(expression e, std::size_t most_terms) {
  return algebra::rewrite<algebra::expansion_reader>(e, most_terms,
                                                     "the expression cannot be multiplied out: ");
}

KANEXPR_ENGINE rewritten collect(expression e, const sequence<expression>& by, std::size_t most_terms) {
  graph& g = e.owner();
  algebra::budget left(most_terms);
  sequence<int> outputs{e.node()};
  for (const expression& each : by) outputs.push(each.node());
  const auto sums = algebra::expansion_reader(g, left).read(outputs);
  if (left.failed()) return {e, "the expression cannot be multiplied out: " + left.cause()};
  std::vector<int> bases;
  for (std::size_t i = 1; i < sums.size(); ++i) {
    const bool is_power = sums[i].size() == 1 && sums[i].terms[0].factors.size() == 1;
    if (!is_power || sums[i].terms[0].factors[0].exponent != 1)
      return {
          e, "an expression can be collected only by symbols and functions, not by sums, products or powers"};
    bases.push_back(sums[i].terms[0].factors[0].base);
  }
  const auto is_collected = [&bases](int base) { return std::ranges::find(bases, base) != bases.end(); };
  expression sum(g, graph::zero);
  for (const auto& [powers, coefficient] : coefficients(sums.front(), is_collected)) {
    const bool negative = algebra::is_all_negative(coefficient);
    const expression magnitude = algebra::to_expression(g, negative ? -coefficient : coefficient);
    const expression numerator = magnitude * algebra::one_sided_product(g, powers, 1);
    const expression term = numerator / algebra::one_sided_product(g, powers, -1);
    sum = negative ? sum - term : sum + term;
  }
  return {sum, {}};
}

} // namespace kanexpr::symbolic
