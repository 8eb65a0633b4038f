#pragma once

#include <kanexpr/symbolic/algebra/expression_reader.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

#include <map>

namespace kanexpr::symbolic::algebra {

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

} // namespace kanexpr::symbolic::algebra
