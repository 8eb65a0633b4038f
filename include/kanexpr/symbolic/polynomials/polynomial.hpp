#pragma once

#include <kanexpr/symbolic/polynomials/budget.hpp>
#include <kanexpr/symbolic/polynomials/exact_numbers.hpp>
#include <kanexpr/symbolic/polynomials/monomial.hpp>

#include <algorithm>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

/// Sums of monomials: arithmetic, obvious common factors, degrees, coefficients, exact quotients.
namespace kanexpr::symbolic::polynomials {

template <class Coefficient>
struct term {
  monomial factors;
  Coefficient coefficient;

  bool operator==(const term&) const = default;
};

/// A sum of nonzero terms, largest monomial first. Exponents may be negative.
template <class Coefficient>
struct polynomial {
  std::vector<term<Coefficient>> terms{};

  polynomial() = default;
  polynomial(const Coefficient& c) {
    if (!c.is_zero()) terms.push_back({{}, c});
  }
  polynomial(monomial m, const Coefficient& c) { terms.push_back({std::move(m), c}); }

  bool is_zero() const { return terms.empty(); }
  bool is_constant() const { return is_zero() || (terms.size() == 1 && terms.front().factors.empty()); }
  bool is_one() const { return *this == polynomial(Coefficient(1)); }
  std::size_t size() const { return terms.size(); }
  bool operator==(const polynomial&) const = default;
};

/// p c m.
template <class Coefficient>
polynomial<Coefficient> scaled(polynomial<Coefficient> p, const Coefficient& c, const monomial& m = {}) {
  for (term<Coefficient>& t : p.terms) {
    t.coefficient = t.coefficient * c;
    if (!m.empty()) t.factors = times(t.factors, m);
  }
  return p;
}

template <class Coefficient>
polynomial<Coefficient> operator-(const polynomial<Coefficient>& p) {
  return scaled(p, Coefficient(-1));
}

template <class Coefficient>
polynomial<Coefficient> operator+(const polynomial<Coefficient>& p, const polynomial<Coefficient>& q) {
  polynomial<Coefficient> sum;
  sum.terms.reserve(p.size() + q.size());
  auto x = p.terms.begin(), y = q.terms.begin();
  while (x != p.terms.end() && y != q.terms.end()) {
    const auto order = compare(x->factors, y->factors);
    if (order != 0) {
      sum.terms.push_back(order > 0 ? *x++ : *y++);
      continue;
    }
    sum.terms.push_back(*x++);
    sum.terms.back().coefficient += (y++)->coefficient;
    if (sum.terms.back().coefficient.is_zero()) sum.terms.pop_back();
  }
  sum.terms.insert(sum.terms.end(), x, p.terms.end());
  sum.terms.insert(sum.terms.end(), y, q.terms.end());
  return sum;
}

template <class Coefficient>
polynomial<Coefficient> operator-(const polynomial<Coefficient>& p, const polynomial<Coefficient>& q) {
  return p + -q;
}

/// Collects terms, in any order and with repetitions, into a polynomial.
template <class Coefficient>
class term_sum {
public:
  void add(const monomial& m, const Coefficient& c) {
    const auto [place, is_new] = coefficients_.try_emplace(m, c);
    if (!is_new) place->second += c;
  }
  std::size_t size() const { return coefficients_.size(); }

  polynomial<Coefficient> sorted() const {
    polynomial<Coefficient> sum;
    for (const auto& [m, c] : coefficients_)
      if (!c.is_zero()) sum.terms.push_back({m, c});
    std::ranges::sort(sum.terms, descending(), &term<Coefficient>::factors);
    return sum;
  }

private:
  std::unordered_map<monomial, Coefficient, monomial_hash> coefficients_{};
};

template <class Coefficient>
bool has_large_exponent(const polynomial<Coefficient>& p) {
  for (const term<Coefficient>& t : p.terms)
    for (const factor& f : t.factors)
      if (f.exponent > largest_exponent || f.exponent < -largest_exponent) return true;
  return false;
}

/// The cost of multiplying by such coefficients, relative to small ones.
template <class Coefficient>
std::size_t effort(const polynomial<Coefficient>& p) {
  std::size_t most = 0;
  for (const term<Coefficient>& t : p.terms) most = (std::max)(most, bits_of(t.coefficient));
  return 1 + (most / 128) * (most / 128);
}

/// Returns zero if the budget is exceeded.
template <class Coefficient>
polynomial<Coefficient> product(const polynomial<Coefficient>& p, const polynomial<Coefficient>& q,
                                budget& left) {
  if (p.size() > q.size()) return product(q, p, left);
  if (p.is_zero() || !left.spend(p.size() * q.size() * (effort(p) + effort(q)) / 2)) return {};
  polynomial<Coefficient> result;
  if (p.size() == 1) {
    result = scaled(q, p.terms.front().coefficient, p.terms.front().factors);
  } else {
    term_sum<Coefficient> sum;
    for (const term<Coefficient>& x : p.terms) {
      for (const term<Coefficient>& y : q.terms)
        sum.add(times(x.factors, y.factors), x.coefficient * y.coefficient);
      if (!left.allows(sum.size())) return {};
    }
    result = sum.sorted();
  }
  if (has_large_exponent(result)) left.fail("an exponent is too large");
  return result;
}

template <class Coefficient>
polynomial<Coefficient> raised(const polynomial<Coefficient>& p, std::int64_t exponent, budget& left) {
  return power_by_squaring(p, static_cast<std::uint64_t>(exponent), polynomial<Coefficient>(Coefficient(1)),
                           [&left](const auto& a, const auto& b) { return product(a, b, left); });
}

struct exponent_range {
  std::int64_t least = 0;
  std::int64_t largest = 0;
};

/// The ranges, keyed by base; if a base is missing from a term, its exponent there is zero.
template <class Coefficient>
std::map<int, exponent_range> exponent_ranges(const polynomial<Coefficient>& p) {
  std::map<int, exponent_range> ranges;
  for (const term<Coefficient>& t : p.terms)
    for (const factor& f : t.factors) ranges.try_emplace(f.base, exponent_range{f.exponent, f.exponent});
  for (auto& [base, range] : ranges)
    for (const term<Coefficient>& t : p.terms) {
      const std::int64_t exponent = exponent_of(t.factors, base);
      range = {(std::min)(range.least, exponent), (std::max)(range.largest, exponent)};
    }
  return ranges;
}

/// The largest monomial of nodes that divides all terms; exponentials are excluded, so that real polynomials
/// stay real.
template <class Coefficient>
monomial common_monomial(const polynomial<Coefficient>& p) {
  monomial common;
  for (const auto& [base, range] : exponent_ranges(p))
    if (base >= 0 && range.least != 0) common.push_back({base, range.least});
  return common;
}

/// The positive number that leaves coprime integer coefficients when it is factored out.
template <class Coefficient>
rational common_number(const polynomial<Coefficient>& p) {
  rational common = 0;
  for (const term<Coefficient>& t : p.terms) common = rational_gcd(common, positive_content(t.coefficient));
  return common;
}

template <class Coefficient>
bool has_decimals(const polynomial<Coefficient>& p) {
  return std::ranges::any_of(p.terms, [](const term<Coefficient>& t) { return is_decimal(t.coefficient); });
}

/// A polynomial written as the product of a number, a monomial and the remaining polynomial.
template <class Coefficient>
struct factored {
  rational number;
  monomial factors;
  polynomial<Coefficient> rest;
};

/// Takes out the common factors of the terms; decimals stay as they are.
template <class Coefficient>
factored<Coefficient> split_content(const polynomial<Coefficient>& p) {
  const rational number = has_decimals(p) ? 1 : common_number(p);
  const monomial factors = common_monomial(p);
  return {number, factors, scaled(p, Coefficient(rational(1) / number), over({}, factors))};
}

/// The coefficients of a polynomial, keyed by the monomials in some of its bases.
template <class Coefficient, class IsTakenOut>
std::map<monomial, polynomial<Coefficient>, descending> coefficients(const polynomial<Coefficient>& p,
                                                                     IsTakenOut is_taken_out) {
  std::map<monomial, polynomial<Coefficient>, descending> parts;
  for (const term<Coefficient>& t : p.terms) {
    monomial out, in;
    for (const factor& f : t.factors) (is_taken_out(f.base) ? out : in).push_back(f);
    parts[out].terms.push_back({in, t.coefficient}); // keeps the order of terms
  }
  return parts;
}

/// p/d if d divides p; nothing if it does not or the budget is exceeded.
template <class Coefficient>
std::optional<polynomial<Coefficient>> exact_quotient(const polynomial<Coefficient>& p,
                                                      const polynomial<Coefficient>& d, budget& left) {
  std::map<int, exponent_range> bounds = exponent_ranges(p);
  for (const auto& [base, range] : exponent_ranges(d)) {
    exponent_range& bound = bounds[base];
    bound = {bound.least - range.least, bound.largest - range.largest};
    if (bound.least > bound.largest) return std::nullopt;
  }
  const auto is_within = [&bounds](const monomial& m) {
    return std::ranges::all_of(bounds, [&m](const auto& bound) {
      const std::int64_t exponent = exponent_of(m, bound.first);
      return exponent >= bound.second.least && exponent <= bound.second.largest;
    });
  };
  if (p.is_zero()) return p;
  if (!is_within(over(p.terms.back().factors, d.terms.back().factors))) return std::nullopt;

  std::map<monomial, Coefficient, descending> rest;
  for (const term<Coefficient>& t : p.terms) rest.emplace(t.factors, t.coefficient);
  polynomial<Coefficient> quotient;
  while (!rest.empty()) {
    const auto& [leading, coefficient] = *rest.begin();
    const monomial step = over(leading, d.terms.front().factors);
    if (!is_within(step) || !left.spend(d.size()) || !left.allows(rest.size())) return std::nullopt;
    const Coefficient weight = coefficient / d.terms.front().coefficient;
    for (const term<Coefficient>& t : d.terms) {
      const auto place = rest.try_emplace(times(step, t.factors), Coefficient(0)).first;
      place->second += -(weight * t.coefficient);
      if (place->second.is_zero()) rest.erase(place);
    }
    quotient.terms.push_back({step, weight});
  }
  return quotient;
}

} // namespace kanexpr::symbolic::polynomials
