#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/build.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

namespace kanexpr::symbolic {

/// A number times powers of nodes, sorted by node number.
struct monomial {
  static constexpr int most_powers = 14;
  struct power {
    int factor = 0;
    int exponent = 0; ///< nonzero
  };
  number coefficient = exactly(1);
  int count = 0;
  power powers[most_powers]{};

  /// Multiplies by a power; returns false if the factor does not fit.
  constexpr bool multiply_by(int factor, int exponent) {
    int place = 0;
    while (place < count && powers[place].factor < factor) ++place;
    if (place < count && powers[place].factor == factor) {
      powers[place].exponent += exponent;
      if (powers[place].exponent != 0) return true;
      for (--count; place < count; ++place) powers[place] = powers[place + 1];
      return true;
    }
    if (count == most_powers) return false;
    for (int i = count++; i > place; --i) powers[i] = powers[i - 1];
    powers[place] = {factor, exponent};
    return true;
  }
  constexpr bool multiply_by(const monomial& other) {
    coefficient = coefficient * other.coefficient;
    for (int i = 0; i < other.count; ++i)
      if (!multiply_by(other.powers[i].factor, other.powers[i].exponent)) return false;
    return true;
  }
  constexpr int exponent_of(int factor) const {
    for (int i = 0; i < count; ++i)
      if (powers[i].factor == factor) return powers[i].exponent;
    return 0;
  }
  constexpr bool has_same_powers(const monomial& other) const {
    if (count != other.count) return false;
    for (int i = 0; i < count; ++i)
      if (powers[i].factor != other.powers[i].factor || powers[i].exponent != other.powers[i].exponent)
        return false;
    return true;
  }
};

/// A short sum of monomials with distinct powers; `fits` is false if it would be too long.
class sum_of_monomials {
public:
  static constexpr int most_terms = 32;

  constexpr sum_of_monomials() = default;
  constexpr explicit sum_of_monomials(const monomial& only) { terms_.push(only); }
  static constexpr sum_of_monomials too_long() {
    sum_of_monomials none;
    none.fits_ = false;
    return none;
  }

  constexpr bool fits() const { return fits_; }
  constexpr int size() const { return terms_.size(); }
  constexpr const monomial& operator[](int i) const { return terms_[i]; }
  constexpr const monomial* begin() const { return terms_.begin(); }
  constexpr const monomial* end() const { return terms_.end(); }

  constexpr void add(const monomial& term) {
    for (monomial& present : terms_) {
      if (!present.has_same_powers(term)) continue;
      present.coefficient = present.coefficient + term.coefficient;
      if (present.coefficient == exactly(0)) drop(static_cast<int>(&present - terms_.begin()));
      return;
    }
    fits_ = fits_ && terms_.size() < most_terms && is_finite(term.coefficient);
    if (fits_) terms_.push(term);
  }
  constexpr void drop(int i) {
    for (; i + 1 < terms_.size(); ++i) terms_[i] = terms_[i + 1];
    terms_.pop();
  }

  constexpr void negate() {
    for (monomial& m : terms_) m.coefficient = -m.coefficient;
  }
  friend constexpr sum_of_monomials operator+(sum_of_monomials a, const sum_of_monomials& b) {
    a.fits_ = a.fits_ && b.fits_;
    for (int i = 0; i < b.size() && a.fits_; ++i) a.add(b[i]);
    return a;
  }
  friend constexpr sum_of_monomials operator*(const sum_of_monomials& a, const sum_of_monomials& b) {
    sum_of_monomials product;
    product.fits_ = a.fits_ && b.fits_;
    for (const monomial& x : a)
      for (const monomial& y : b) {
        if (!product.fits_) return too_long();
        monomial both = x;
        if (!both.multiply_by(y)) return too_long();
        product.add(both);
      }
    return product;
  }

private:
  sequence<monomial> terms_{};
  bool fits_ = true;
};

/// Replaces terms sin² X and cos² X, with equal factors X, by X; returns whether there were any.
constexpr bool combine_sine_cosine_squares(const graph& g, sum_of_monomials& s) {
  const auto joined = [&] {
    for (int i = 0; i < s.size(); ++i)
      for (int k = 0; k < s[i].count; ++k) {
        const int sine = s[i].powers[k].factor;
        if (g[sine].op != operation::sin || s[i].powers[k].exponent < 2) continue;
        const int cosine = g.find({operation::cos, g[sine].a, 0});
        monomial one = s[i];
        one.multiply_by(sine, -2);
        monomial other = one;
        if (cosine < 0 || !other.multiply_by(cosine, 2)) continue;
        for (int j = 0; j < s.size(); ++j) {
          if (!s[j].has_same_powers(other)) continue;
          if (!(s[j].coefficient - other.coefficient == exactly(0))) break; // up to decimal rounding
          s.drop(i < j ? j : i);
          s.drop(i < j ? i : j);
          s.add(one);
          return true;
        }
      }
    return false;
  };
  bool any = false;
  while (joined()) any = true;
  return any;
}

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
