#pragma once

#include <kanexpr/symbolic/polynomials/polynomial_parts.hpp>

namespace kanexpr::symbolic::algebra {

/// A polynomial over a product of powers of other polynomials, identified by their indices in a list.
template <class Coefficient>
struct fraction {
  polynomial<Coefficient> above{};
  std::map<std::size_t, std::int64_t> below{}; ///< positive exponents
};

/// Arithmetic of fractions. Denominators stay factored, and each factor is canceled as often as it divides
/// the numerator.
template <class Coefficient>
class fraction_arithmetic {
public:
  explicit fraction_arithmetic(budget& left) : left_(left) {}

  const polynomial<Coefficient>& divisor(std::size_t place) const { return divisors_[place]; }

  /// Sets the square of a node, to be used wherever it occurs.
  void set_square(int root, const fraction<Coefficient>& square) { squares_[root] = square; }

  fraction<Coefficient> sum(const fraction<Coefficient>& a, const fraction<Coefficient>& b) {
    if (a.below == b.below) return simplified({a.above + b.above, a.below});
    fraction<Coefficient> all;
    for (const fraction<Coefficient>* each : {&a, &b})
      for (const auto& [place, exponent] : each->below)
        all.below[place] = (std::max)(all.below[place], exponent);
    fraction<Coefficient> result = without_squares(brought_to(a, all) + brought_to(b, all));
    for (const auto& [place, exponent] : all.below) result.below[place] += exponent;
    return simplified(std::move(result));
  }

  fraction<Coefficient> negative(const fraction<Coefficient>& a) { return {-a.above, a.below}; }

  fraction<Coefficient> product(const fraction<Coefficient>& a, const fraction<Coefficient>& b) {
    fraction<Coefficient> result = without_squares(algebra::product(a.above, b.above, left_));
    for (const fraction<Coefficient>* each : {&a, &b})
      for (const auto& [place, exponent] : each->below) result.below[place] += exponent;
    return simplified(std::move(result));
  }

  /// Requires that b is not zero.
  fraction<Coefficient> quotient(const fraction<Coefficient>& a, const fraction<Coefficient>& b) {
    const fraction<Coefficient> below = divided_by(b.above);
    std::map<std::size_t, std::int64_t> exponents = a.below;
    for (const auto& [place, exponent] : below.below) exponents[place] += exponent;
    for (const auto& [place, exponent] : b.below) exponents[place] -= exponent;
    fraction<Coefficient> result = without_squares(algebra::product(a.above, below.above, left_));
    for (const auto& [place, exponent] : exponents) {
      if (exponent > 0) result.below[place] += exponent;
      if (exponent < 0) result = product(result, {raised(divisors_[place], -exponent, left_), {}});
    }
    return simplified(std::move(result));
  }

private:
  polynomial<Coefficient> brought_to(const fraction<Coefficient>& a, const fraction<Coefficient>& common) {
    polynomial<Coefficient> above = a.above;
    for (const auto& [place, exponent] : common.below) {
      const auto own = a.below.find(place);
      const std::int64_t missing = exponent - (own == a.below.end() ? 0 : own->second);
      if (missing > 0) above = algebra::product(above, raised(divisors_[place], missing, left_), left_);
    }
    return above;
  }

  fraction<Coefficient> simplified(fraction<Coefficient> a) {
    if (a.above.is_zero()) a.below.clear();
    for (auto& [place, exponent] : a.below)
      while (exponent > 0 && !left_.failed()) {
        const auto quotient = exact_quotient(a.above, divisors_[place], left_);
        if (!quotient) break;
        a.above = *quotient;
        --exponent;
      }
    std::erase_if(a.below, [](const auto& each) { return each.second == 0; });
    return a;
  }

  /// 1/p: numbers and powers of nodes are inverted directly; the remaining polynomial becomes a divisor,
  /// split into known factors.
  fraction<Coefficient> divided_by(const polynomial<Coefficient>& p) {
    const monomial shared = common_monomial(p);
    rational scale = holds_decimals(p) ? 1 : common_number(p);
    if (is_negative(p.terms.front().coefficient)) scale = -scale;
    fraction<Coefficient> result{{over({}, shared), Coefficient(1) / Coefficient(scale)}, {}};
    polynomial<Coefficient> rest = scaled(p, Coefficient(1) / Coefficient(scale), over({}, shared));
    for (std::size_t i = 0; i < divisors_.size() && !rest.is_constant(); ++i)
      while (const auto quotient = exact_quotient(rest, divisors_[i], left_)) {
        rest = *quotient;
        ++result.below[i];
      }
    if (rest.is_constant()) {
      if (!rest.is_zero())
        result.above = scaled(result.above, Coefficient(1) / rest.terms.front().coefficient);
      return result;
    }
    ++result.below[divisors_.size()];
    divisors_.push_back(rest);
    return result;
  }

  /// Leaves only first powers of square roots.
  fraction<Coefficient> without_squares(const polynomial<Coefficient>& p) {
    const int root = squared_root(p);
    if (root == none) return {p, {}};
    std::map<std::int64_t, term_sum<Coefficient>> by_square;
    for (const term<Coefficient>& t : p.terms) {
      const std::int64_t exponent = exponent_of(t.factors, root), rest = exponent & 1;
      const monomial others = without(t.factors, root);
      by_square[(exponent - rest) / 2].add(rest == 0 ? others : times(others, {{root, 1}}), t.coefficient);
    }
    fraction<Coefficient> all;
    for (const auto& [exponent, terms] : by_square) {
      const fraction<Coefficient> part = without_squares(terms.sorted());
      all = sum(all, product(part, square_raised(root, exponent)));
    }
    return all;
  }

  fraction<Coefficient> square_raised(int root, std::int64_t exponent) {
    const fraction<Coefficient> one{Coefficient(1), {}};
    fraction<Coefficient> result = one, power = squares_.find(root)->second;
    if (exponent < 0) power = quotient(one, power);
    for (std::int64_t rest = std::abs(exponent); rest > 0 && !left_.failed(); rest /= 2) {
      if (rest % 2 != 0) result = product(result, power);
      if (rest > 1) power = product(power, power);
    }
    return result;
  }

  int squared_root(const polynomial<Coefficient>& p) const {
    if (squares_.empty()) return none;
    for (const term<Coefficient>& t : p.terms)
      for (const factor& f : t.factors)
        if ((f.exponent > 1 || f.exponent < 0) && squares_.contains(f.base)) return f.base;
    return none;
  }

  static constexpr int none = -1;

  budget& left_;
  std::vector<polynomial<Coefficient>> divisors_{};
  std::map<int, fraction<Coefficient>> squares_{};
};

} // namespace kanexpr::symbolic::algebra
