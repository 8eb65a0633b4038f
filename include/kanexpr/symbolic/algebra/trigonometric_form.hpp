#pragma once

#include <kanexpr/symbolic/algebra/angle.hpp>
#include <kanexpr/symbolic/algebra/forms.hpp>
#include <kanexpr/symbolic/algebra/fraction_reader.hpp>
#include <kanexpr/symbolic/algebra/rewritten.hpp>

#include <set>

namespace kanexpr::symbolic {

namespace algebra {

/// Reads expressions as fractions of trigonometric polynomials; functions other than sine, cosine and tangent
/// are treated as symbols.
class trigonometric_reader : public fraction_reader<gaussian, trigonometric_reader> {
public:
  trigonometric_reader(graph& g, budget& left) : fraction_reader(g, left), angles_(g) {}

  expression written(const fraction& f) {
    if (f.below.empty()) return sum_in(owner(), angles_.in_sines(f.above));
    real_fraction real{angles_.in_sines(f.above), {}};
    for (const auto& [place, exponent] : f.below)
      real.below.emplace_back(angles_.in_sines(arithmetic().divisor(place)), exponent);
    return quotient_in(owner(), real);
  }

  unsigned_argument argument(const fraction& f) {
    const bool negative = leads_with_minus(owner(), angles_.in_sines(f.above));
    return {written(negative ? arithmetic().negative(f) : f), negative};
  }

  /// The numerator and denominator of a trigonometric function.
  std::optional<std::pair<trigonometric_polynomial, trigonometric_polynomial>> function(operation op,
                                                                                        const fraction& x) {
    const trigonometric_polynomial one(1);
    if (op != operation::sin && op != operation::cos && op != operation::tan) return std::nullopt;
    const monomial e = exponential(x), conjugate = over({}, e);
    const gaussian half(rational(1) / rational(2)), half_over_i(0, -half.real);
    const auto sum = [&](const gaussian& a, const gaussian& b) {
      return trigonometric_polynomial(e, a) + trigonometric_polynomial(conjugate, b);
    };
    if (op == operation::cos) return std::pair(sum(half, half), one);
    const trigonometric_polynomial sine = sum(half_over_i, -half_over_i);
    return std::pair(sine, op == operation::sin ? one : sum(half, half));
  }

  void meets_opaque(int node) { opaque_.insert(node); }

  /// Whether a polynomial contains functions treated as symbols, so that it may be zero although its form is
  /// not.
  bool holds_unknown(const trigonometric_polynomial& p) const {
    return std::ranges::any_of(p.terms, [this](const term<gaussian>& t) { return holds_unknown(t.factors); });
  }

private:
  monomial exponential(const fraction& x) {
    const auto plain = x.below.empty() ? without_angles(x.above) : std::nullopt;
    if (plain) return angles_.exponential(*plain);
    const unsigned_argument whole = argument(x);
    return angles_.of_its_own(whole.magnitude.node(), whole.negative ? -1 : 1);
  }

  bool holds_unknown(const monomial& m) const {
    return std::ranges::any_of(m, [this](const factor& f) {
      if (f.base >= 0) return opaque_.contains(f.base);
      const monomial* const angle = angles_.factors_of(~f.base);
      return angle == nullptr || holds_unknown(*angle);
    });
  }

  angles angles_;
  std::set<int> opaque_{};
};

} // namespace algebra

KANEXPR_ENGINE rewritten trigonometric_normal_form(expression e, std::size_t most_terms) {
  algebra::budget left(most_terms);
  algebra::trigonometric_reader reader(e.owner(), left);
  const auto fractions = reader.read({e.node()});
  const expression result = left.failed() ? e : reader.written(fractions.front());
  if (left.failed()) return {e, "the expression has no trigonometric normal form: " + left.cause()};
  return {result, {}};
}

} // namespace kanexpr::symbolic
