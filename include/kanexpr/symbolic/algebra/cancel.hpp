#pragma once

#include <kanexpr/symbolic/algebra/forms.hpp>
#include <kanexpr/symbolic/algebra/fraction_reader.hpp>
#include <kanexpr/symbolic/algebra/quotient_of_sums.hpp>
#include <kanexpr/symbolic/algebra/rewritten.hpp>
#include <kanexpr/symbolic/polynomials/polynomial_gcd.hpp>

namespace kanexpr::symbolic {

namespace algebra {

/// Reads expressions as fractions in lowest terms; functions are treated as symbols.
class cancelling_reader : public fraction_reader<rational, cancelling_reader> {
public:
  cancelling_reader(graph& g, budget& left) : fraction_reader(g, left), left_(left) {}

  expression written(const fraction& f) { return quotient_in(owner(), lowest_terms(f)); }

  unsigned_argument argument(const fraction& f) {
    const bool negative = leads_with_minus(owner(), f.above);
    return {written(negative ? arithmetic().negative(f) : f), negative};
  }
  std::optional<std::pair<real_polynomial, real_polynomial>> function(operation, const fraction&) {
    return {};
  }
  void meets_opaque(int) {}

private:
  using powers = std::vector<std::pair<real_polynomial, std::int64_t>>;

  real_fraction lowest_terms(const fraction& f) {
    powers below;
    for (const auto& [place, exponent] : f.below) below.emplace_back(arithmetic().divisor(place), exponent);
    real_fraction lowest{f.above, {}};
    while (!below.empty() && !left_.failed()) {
      const auto [divisor, exponent] = below.back();
      below.pop_back();
      if (divisor.is_constant()) {
        lowest.above = divided(lowest.above, raised(divisor, exponent, left_));
        continue;
      }
      const real_polynomial common = divisor_search(left_).common_divisor(lowest.above, divisor);
      if (common.is_constant()) {
        lowest.below.emplace_back(divisor, exponent);
        continue;
      }
      lowest.above = divided(lowest.above, common);
      below.emplace_back(divided(divisor, common), exponent);
      if (exponent > 1) below.emplace_back(common, exponent - 1);
    }
    return {lowest.above, coprime(std::move(lowest.below))};
  }

  /// The same product with pairwise coprime factors.
  powers coprime(powers all) {
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t j = 0; j < i && !left_.failed(); ++j) {
        const real_polynomial common = divisor_search(left_).common_divisor(all[i].first, all[j].first);
        if (common.is_constant()) continue;
        for (const std::size_t k : {i, j}) all[k].first = divided(all[k].first, common);
        all.emplace_back(common, all[i].second + all[j].second);
        return coprime(std::move(all));
      }
    return all;
  }

  real_polynomial divided(const real_polynomial& p, const real_polynomial& by) {
    const auto quotient = exact_quotient(p, by, left_);
    return quotient ? *quotient : p;
  }

  budget& left_;
};

} // namespace algebra

KANEXPR_ENGINE rewritten cancel(expression e, std::size_t most_terms) {
  algebra::budget left(most_terms);
  algebra::cancelling_reader reader(e.owner(), left);
  const auto fractions = reader.read({e.node()});
  const expression result = left.failed() ? e : reader.written(fractions.front());
  if (left.failed()) return {e, "the expression cannot be cancelled: " + left.cause()};
  return {result, {}};
}

} // namespace kanexpr::symbolic
