#pragma once

#include <kanexpr/symbolic/algebra/angle.hpp>
#include <kanexpr/symbolic/algebra/expression_reader.hpp>
#include <kanexpr/symbolic/algebra/forms.hpp>
#include <kanexpr/symbolic/algebra/rewritten.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

#include <optional>
#include <set>
#include <utility>

namespace kanexpr::symbolic {

namespace algebra {

/// Reads expressions as fractions of trigonometric polynomials; functions other than sine, cosine and tangent
/// are treated as symbols.
class trigonometric_reader : public fraction_reader<gaussian, trigonometric_reader> {
public:
  trigonometric_reader(graph& g, budget& left) : fraction_reader(g, left), angles_(g) {}

  expression written(const fraction& f) {
    if (f.denominator.empty()) return to_expression(owner(), angles_.to_sines_and_cosines(f.numerator));
    real_fraction real{angles_.to_sines_and_cosines(f.numerator), {}};
    for (const auto& [place, exponent] : f.denominator)
      real.denominator.emplace_back(angles_.to_sines_and_cosines(divisor(place)), exponent);
    return to_expression(owner(), real);
  }

  bool has_minus(const fraction& f) {
    return has_negative_leading_term(owner(), angles_.to_sines_and_cosines(f.numerator));
  }

  /// The numerator and denominator of a trigonometric function.
  std::optional<std::pair<trigonometric_polynomial, trigonometric_polynomial>>
  known_function(operation op, const fraction& x) {
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

  void on_opaque_function(int node) { opaque_.insert(node); }

  /// Whether a polynomial contains functions treated as symbols and so may be zero even though its terms do
  /// not cancel.
  bool has_opaque_functions(const trigonometric_polynomial& p) const {
    return std::ranges::any_of(p.terms,
                               [this](const term<gaussian>& t) { return has_opaque_functions(t.factors); });
  }

private:
  monomial exponential(const fraction& x) {
    const auto plain = x.denominator.empty() ? without_angles(x.numerator) : std::nullopt;
    if (plain) return angles_.exponential(*plain);
    const unsigned_argument whole = argument(x);
    return angles_.independent_angle(whole.magnitude.node(), whole.negative ? -1 : 1);
  }

  bool has_opaque_functions(const monomial& m) const {
    return std::ranges::any_of(m, [this](const factor& f) {
      if (f.base >= 0) return opaque_.contains(f.base);
      const monomial* const angle = angles_.factors_of(~f.base);
      return angle == nullptr || has_opaque_functions(*angle);
    });
  }

  angles angles_;
  std::set<int> opaque_{};
};

} // namespace algebra

KANEXPR_ENGINE rewritten trigonometric_normal_form(expression e, std::size_t most_terms) {
  return algebra::rewrite<algebra::trigonometric_reader>(e, most_terms,
                                                         "the expression has no trigonometric normal form: ");
}

} // namespace kanexpr::symbolic
