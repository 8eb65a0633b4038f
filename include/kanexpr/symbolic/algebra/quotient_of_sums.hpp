#pragma once

#include <kanexpr/symbolic/algebra/sum_of_terms.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>

#include <utility>
#include <vector>

namespace kanexpr::symbolic::algebra {

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

} // namespace kanexpr::symbolic::algebra
