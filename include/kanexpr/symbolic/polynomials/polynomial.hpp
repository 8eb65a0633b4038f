#pragma once

#include <kanexpr/symbolic/polynomials/budget.hpp>
#include <kanexpr/symbolic/polynomials/exact_numbers.hpp>
#include <kanexpr/symbolic/polynomials/monomial.hpp>

#include <unordered_map>
#include <utility>
#include <vector>

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

/// The cost of a product with such coefficients, relative to small ones.
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

} // namespace kanexpr::symbolic::polynomials
