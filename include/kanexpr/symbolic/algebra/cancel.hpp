#pragma once

#include <kanexpr/symbolic/algebra/expression_reader.hpp>
#include <kanexpr/symbolic/algebra/forms.hpp>
#include <kanexpr/symbolic/algebra/rewritten.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/polynomials/polynomial_gcd.hpp>

#include <optional>
#include <utility>
#include <vector>

namespace kanexpr::symbolic {

namespace algebra {

/// Reads expressions as fractions in lowest terms; functions are treated as symbols.
class canceling_reader : public fraction_reader<rational, canceling_reader> {
public:
  using fraction_reader::fraction_reader;

  expression written(const fraction& f) { return to_expression(owner(), lowest_terms(f)); }

  bool has_minus(const fraction& f) { return has_negative_leading_term(owner(), f.numerator); }
  std::optional<std::pair<real_polynomial, real_polynomial>> known_function(operation, const fraction&) {
    return {};
  }
  void on_opaque_function(int) {}

private:
  using powers = std::vector<std::pair<real_polynomial, std::int64_t>>;

  real_fraction lowest_terms(const fraction& f) {
    powers denominator;
    for (const auto& [place, exponent] : f.denominator) denominator.emplace_back(divisor(place), exponent);
    real_fraction lowest{f.numerator, {}};
    while (!denominator.empty() && !left().failed()) {
      const auto [divisor, exponent] = denominator.back();
      denominator.pop_back();
      if (divisor.is_constant()) {
        lowest.numerator = divided(lowest.numerator, raised(divisor, exponent, left()));
        continue;
      }
      const real_polynomial common = divisor_search(left()).common_divisor(lowest.numerator, divisor);
      if (common.is_constant()) {
        lowest.denominator.emplace_back(divisor, exponent);
        continue;
      }
      lowest.numerator = divided(lowest.numerator, common);
      denominator.emplace_back(divided(divisor, common), exponent);
      if (exponent > 1) denominator.emplace_back(common, exponent - 1);
    }
    return {lowest.numerator, coprime(std::move(lowest.denominator))};
  }

  /// The same product with pairwise coprime factors.
  powers coprime(powers all) {
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t j = 0; j < i && !left().failed(); ++j) {
        const real_polynomial common = divisor_search(left()).common_divisor(all[i].first, all[j].first);
        if (common.is_constant()) continue;
        for (const std::size_t k : {i, j}) all[k].first = divided(all[k].first, common);
        all.emplace_back(common, all[i].second + all[j].second);
        return coprime(std::move(all));
      }
    return all;
  }

  real_polynomial divided(const real_polynomial& p, const real_polynomial& by) {
    const auto quotient = exact_quotient(p, by, left());
    return quotient ? *quotient : p;
  }
};

} // namespace algebra

KANEXPR_ENGINE rewritten cancel(expression e, std::size_t most_terms) {
  return algebra::rewrite<algebra::canceling_reader>(e, most_terms, "the expression cannot be cancelled: ");
}

} // namespace kanexpr::symbolic
