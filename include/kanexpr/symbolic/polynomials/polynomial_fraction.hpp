#pragma once

#include <kanexpr/symbolic/polynomials/polynomial.hpp>

#include <map>
#include <utility>
#include <vector>

namespace kanexpr::symbolic::polynomials {

/// A polynomial over a product of powers of other polynomials, identified by their indices in a list.
template <class Coefficient>
struct fraction {
  polynomial<Coefficient> numerator{};
  std::map<std::size_t, std::int64_t> denominator{}; ///< positive exponents
};

/// Arithmetic of fractions. Denominators stay factored, and each factor is canceled as many times as it
/// divides the numerator.
template <class Coefficient>
class fraction_arithmetic {
public:
  using fraction = polynomials::fraction<Coefficient>;

  explicit fraction_arithmetic(budget& left) : left_(left) {}

  const polynomial<Coefficient>& divisor(std::size_t place) const { return divisors_[place]; }

  /// Sets the square of a node, to be used wherever it occurs.
  void set_square(int root, const fraction& square) { squares_[root] = square; }

  fraction sum(const fraction& a, const fraction& b) {
    if (a.denominator == b.denominator) return simplified({a.numerator + b.numerator, a.denominator});
    fraction all;
    for (const fraction* each : {&a, &b})
      for (const auto& [place, exponent] : each->denominator)
        all.denominator[place] = (std::max)(all.denominator[place], exponent);
    fraction result = without_squares(brought_to(a, all) + brought_to(b, all));
    for (const auto& [place, exponent] : all.denominator) result.denominator[place] += exponent;
    return simplified(std::move(result));
  }

  fraction negative(const fraction& a) { return {-a.numerator, a.denominator}; }

  fraction product(const fraction& a, const fraction& b) {
    fraction result = without_squares(polynomials::product(a.numerator, b.numerator, left_));
    for (const fraction* each : {&a, &b})
      for (const auto& [place, exponent] : each->denominator) result.denominator[place] += exponent;
    return simplified(std::move(result));
  }

  /// Fails if b is zero.
  fraction quotient(const fraction& a, const fraction& b) {
    if (b.numerator.is_zero()) {
      left_.fail("it divides by an expression that is zero everywhere");
      return {};
    }
    const fraction inverse = reciprocal(b.numerator);
    std::map<std::size_t, std::int64_t> exponents = a.denominator;
    for (const auto& [place, exponent] : inverse.denominator) exponents[place] += exponent;
    for (const auto& [place, exponent] : b.denominator) exponents[place] -= exponent;
    fraction result = without_squares(polynomials::product(a.numerator, inverse.numerator, left_));
    for (const auto& [place, exponent] : exponents) {
      if (exponent > 0) result.denominator[place] += exponent;
      if (exponent < 0) result = product(result, {raised(divisors_[place], -exponent, left_), {}});
    }
    return simplified(std::move(result));
  }

private:
  polynomial<Coefficient> brought_to(const fraction& a, const fraction& common) {
    polynomial<Coefficient> numerator = a.numerator;
    for (const auto& [place, exponent] : common.denominator) {
      const auto own = a.denominator.find(place);
      const std::int64_t missing = exponent - (own == a.denominator.end() ? 0 : own->second);
      if (missing > 0)
        numerator = polynomials::product(numerator, raised(divisors_[place], missing, left_), left_);
    }
    return numerator;
  }

  fraction simplified(fraction a) {
    if (a.numerator.is_zero()) a.denominator.clear();
    for (auto& [place, exponent] : a.denominator)
      while (exponent > 0 && !left_.failed()) {
        const auto quotient = exact_quotient(a.numerator, divisors_[place], left_);
        if (!quotient) break;
        a.numerator = *quotient;
        --exponent;
      }
    std::erase_if(a.denominator, [](const auto& each) { return each.second == 0; });
    return a;
  }

  /// 1/p: numbers and powers of nodes are inverted directly; the remaining polynomial becomes a divisor,
  /// split into known factors.
  fraction reciprocal(const polynomial<Coefficient>& p) {
    auto [scale, shared, rest] = split_content(p);
    if (is_negative(p.terms.front().coefficient)) scale = -scale, rest = -rest;
    fraction result{{over({}, shared), Coefficient(1) / Coefficient(scale)}, {}};
    for (std::size_t i = 0; i < divisors_.size() && !rest.is_constant(); ++i)
      while (const auto quotient = exact_quotient(rest, divisors_[i], left_)) {
        rest = *quotient;
        ++result.denominator[i];
      }
    if (rest.is_constant()) {
      if (!rest.is_zero())
        result.numerator = scaled(result.numerator, Coefficient(1) / rest.terms.front().coefficient);
      return result;
    }
    ++result.denominator[divisors_.size()];
    divisors_.push_back(rest);
    return result;
  }

  /// Leaves only first powers of square roots.
  fraction without_squares(const polynomial<Coefficient>& p) {
    const int root = squared_root(p);
    if (root == none) return {p, {}};
    std::map<std::int64_t, term_sum<Coefficient>> by_square;
    for (const term<Coefficient>& t : p.terms) {
      const std::int64_t exponent = exponent_of(t.factors, root), rest = exponent & 1;
      const monomial others = without(t.factors, root);
      by_square[(exponent - rest) / 2].add(rest == 0 ? others : times(others, {{root, 1}}), t.coefficient);
    }
    fraction all;
    for (const auto& [exponent, terms] : by_square) {
      const fraction part = without_squares(terms.sorted());
      all = sum(all, product(part, square_raised(root, exponent)));
    }
    return all;
  }

  fraction square_raised(int root, std::int64_t exponent) {
    const fraction one{Coefficient(1), {}};
    const fraction& square = squares_.find(root)->second;
    return power_by_squaring(exponent < 0 ? quotient(one, square) : square,
                             static_cast<std::uint64_t>(std::abs(exponent)), one,
                             [this](const auto& a, const auto& b) { return product(a, b); });
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
  std::map<int, fraction> squares_{};
};

} // namespace kanexpr::symbolic::polynomials
