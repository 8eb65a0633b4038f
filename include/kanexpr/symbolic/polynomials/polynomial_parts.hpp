#pragma once

#include <kanexpr/symbolic/polynomials/polynomial.hpp>

#include <map>
#include <optional>

/// Parts of polynomials: obvious common factors, degrees, coefficients, exact quotients.
namespace kanexpr::symbolic::polynomials {

struct exponent_range {
  std::int64_t least = 0;
  std::int64_t largest = 0;
};

/// The ranges by base; a base missing from some terms has exponent zero there.
template <class Coefficient>
std::map<int, exponent_range> exponent_ranges(const polynomial<Coefficient>& p) {
  std::map<int, exponent_range> ranges;
  std::map<int, std::size_t> occurrences;
  for (const term<Coefficient>& t : p.terms)
    for (const factor& f : t.factors) {
      const auto place = ranges.try_emplace(f.base, exponent_range{f.exponent, f.exponent}).first;
      place->second.least = (std::min)(place->second.least, f.exponent);
      place->second.largest = (std::max)(place->second.largest, f.exponent);
      ++occurrences[f.base];
    }
  for (auto& [base, range] : ranges)
    if (occurrences[base] < p.size()) {
      range.least = (std::min)(range.least, std::int64_t{0});
      range.largest = (std::max)(range.largest, std::int64_t{0});
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

/// The positive number whose removal leaves coprime integer coefficients.
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

/// A polynomial as a number times a monomial times the remaining polynomial.
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

/// The coefficients of a polynomial, by the monomials in some of its bases.
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
