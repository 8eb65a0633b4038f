#pragma once

#include <kanexpr/symbolic/algebra/sum_of_terms.hpp>

namespace kanexpr::symbolic::algebra {

/// A polynomial divided by powers of other polynomials, ready to be written as an expression.
struct real_fraction {
  real_polynomial above;
  std::vector<std::pair<real_polynomial, std::int64_t>> below;
};

/// A polynomial split into a numerical and monomial factor and the remaining polynomial.
struct factored {
  term<rational> outside{{}, 1};
  real_polynomial inside;
};

inline factored factored_out(const real_polynomial& p) {
  const rational c = holds_decimals(p) ? 1 : common_number(p);
  const monomial m = common_monomial(p);
  return {{m, c}, scaled(p, rational(1) / c, over({}, m))};
}

/// Writes common factors in front; the signs of the sums do not depend on node numbers.
inline expression quotient_in(graph& g, const real_fraction& f) {
  if (f.above.is_zero()) return {g, graph::zero};
  auto [front, above] = factored_out(f.above);
  bool negative = is_all_negative(above);
  expression divisors(g, graph::one);
  for (const auto& [divisor, exponent] : f.below) {
    auto [outside, inside] = factored_out(divisor);
    const bool flipped = leads_with_minus(g, inside);
    if (flipped && exponent % 2 != 0) negative = !negative;
    const int sum = sum_in(g, flipped ? -inside : inside).node();
    divisors *= expression(g, integer_power(g, sum, exponent));
    for (std::int64_t i = 0; i < exponent; ++i) front.coefficient = front.coefficient / outside.coefficient;
    front.factors = times(front.factors, outside.factors, -exponent);
  }
  const expression sum = sum_in(g, is_all_negative(above) ? -above : above);
  const expression coefficient = number_in(g, front.coefficient);
  const expression numerator = coefficient * side_of(g, front.factors, 1) * sum;
  const expression quotient = numerator / (side_of(g, front.factors, -1) * divisors);
  return negative ? -quotient : quotient;
}

} // namespace kanexpr::symbolic::algebra
