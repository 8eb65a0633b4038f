#pragma once

#include <kanexpr/symbolic/algebra/bottom_up.hpp>
#include <kanexpr/symbolic/algebra/sum_of_terms.hpp>

namespace kanexpr::symbolic {

namespace algebra {

/// Reads expressions as sums of products of powers. Functions are treated as symbols, and a sum in a
/// denominator as one factor.
class expansion_reader {
public:
  expansion_reader(graph& g, budget& left) : g_(g), left_(left) {}

  /// Returns nothing if the budget is exceeded.
  std::vector<real_polynomial> read(const sequence<int>& outputs) {
    const auto size_of = [](const real_polynomial& p) { return p.size(); };
    return bottom_up<real_polynomial>(
        g_, without_small_solves(g_, outputs), left_, size_of,
        [this](int id, const real_polynomial& a, const real_polynomial& b) { return value(id, a, b); });
  }

private:
  real_polynomial value(int id, const real_polynomial& a, const real_polynomial& b) {
    const operation op = g_[id].op;
    if (op == operation::negate) return -a;
    if (op == operation::add) return a + b;
    if (op == operation::subtract) return a - b;
    if (op == operation::multiply) return multiplied(product(a, b, left_));
    if (op == operation::divide)
      return b.is_zero() ? over_zero(a) : multiplied(product(a, inverse(b), left_));
    if (is_atomic(op)) return atom<rational>({g_, id});
    const unsigned_argument x = argument(a), y = argument(b);
    const real_polynomial f = function_of<rational>(op, x, y);
    if (op == operation::sqrt && f.size() == 1 && !f.is_constant()) meanings_[f.terms[0].factors[0].base] = a;
    return f;
  }

  unsigned_argument argument(const real_polynomial& p) {
    const bool negative = leads_with_minus(g_, p);
    return {sum_in(g_, negative ? -p : p), negative};
  }

  real_polynomial over_zero(const real_polynomial& a) {
    return {{{(sum_in(g_, a) / expression(g_, graph::zero)).node(), 1}}, rational(1)};
  }

  real_polynomial inverse(const real_polynomial& p) {
    if (p.size() == 1) return {over({}, p.terms.front().factors), rational(1) / p.terms.front().coefficient};
    const monomial shared = common_monomial(p);
    rational c = holds_decimals(p) ? 1 : common_number(p);
    if (leads_with_minus(g_, p)) c = -c;
    const real_polynomial sum = scaled(p, rational(1) / c, over({}, shared));
    const int base = sum_in(g_, sum).node();
    meanings_[base] = sum;
    return {over({}, times(shared, {{base, 1}})), rational(1) / c};
  }

  /// Replaces squares of roots by their radicands, and denominator sums that move to a numerator by their
  /// terms.
  real_polynomial multiplied(const real_polynomial& p) {
    const int base = meanings_.empty() ? none : outer_base(p);
    if (base == none) return p;
    real_polynomial open, others;
    for (const term<rational>& t : p.terms)
      (is_outer(base, exponent_of(t.factors, base)) ? open : others).terms.push_back(t);
    real_polynomial sum = multiplied(others);
    for (const auto& [power, rest] : coefficients<rational>(open, [base](int b) { return b == base; })) {
      const std::int64_t exponent = power.front().exponent;
      const std::int64_t root = is_root(base) ? exponent % 2 : 0;
      const std::int64_t whole = is_root(base) ? exponent / 2 : exponent;
      const real_polynomial& meaning = meanings_.find(base)->second;
      const real_polynomial value = raised(whole < 0 ? inverse(meaning) : meaning, std::abs(whole), left_);
      const monomial kept = root == 0 ? monomial{} : monomial{{base, root}};
      sum = sum + multiplied(product(scaled(rest, rational(1), kept), value, left_));
      if (!left_.allows(sum.size())) return {};
    }
    return sum;
  }

  static constexpr int none = -1;

  int outer_base(const real_polynomial& p) const {
    for (const term<rational>& t : p.terms)
      for (const factor& f : t.factors)
        if (meanings_.contains(f.base) && is_outer(f.base, f.exponent)) return f.base;
    return none;
  }
  bool is_root(int base) const { return g_[base].op == operation::sqrt; }
  bool is_outer(int base, std::int64_t exponent) const {
    return is_root(base) ? exponent > 1 || exponent < -1 : exponent > 0;
  }

  graph& g_;
  budget& left_;
  std::map<int, real_polynomial> meanings_{}; ///< radicands and sums in denominators
};

} // namespace algebra

} // namespace kanexpr::symbolic
