#pragma once

#include <kanexpr/symbolic/algebra/sum_of_terms.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

#include <map>
#include <optional>

namespace kanexpr::symbolic::algebra {

/// Polynomials in nodes and in exponentials e^{iθ/720720}, where θ is the node with number ~base. Sines and
/// cosines of sums of angles θ, with multiples down to sixteenths, are monomials in these, and a sum of
/// distinct monomials is never zero: each function has a unique form.
using trigonometric_polynomial = polynomial<gaussian>;

inline constexpr std::int64_t parts_of_angle = 720'720; // the least common multiple of 1 to 16

/// Returns nothing if a term contains an exponential or is not real.
inline std::optional<real_polynomial> without_angles(const trigonometric_polynomial& p) {
  real_polynomial real;
  for (const term<gaussian>& t : p.terms) {
    if (!t.coefficient.imaginary.is_zero()) return std::nullopt;
    if (std::ranges::any_of(t.factors, [](const factor& f) { return f.base < 0; })) return std::nullopt;
    real.terms.push_back({t.factors, t.coefficient.real});
  }
  return real;
}

/// Converts between angles and sums of multiples of nodes.
class angles {
public:
  explicit angles(graph& g) : g_(g) {}

  /// e^{iθ} for a sum θ. If a coefficient is not a multiple of 1/720720, for instance if it is a decimal
  /// number, its term is treated as an independent angle.
  monomial exponential(const real_polynomial& angle) {
    monomial all;
    for (const term<rational>& t : angle.terms) {
      const rational parts = t.coefficient * rational(parts_of_angle);
      constexpr std::int64_t most_turns = 1 << 20;
      if (parts.is_integer() && abs(parts.numerator()) <= most_turns * parts_of_angle) {
        const int node = to_expression(g_, term<rational>{t.factors, 1}).node();
        factors_.emplace(node, t.factors);
        all = times(all, {{~node, parts.numerator().convert_to<std::int64_t>()}});
      } else {
        all = times(all,
                    independent_angle(
                        to_expression(g_, term<rational>{t.factors, positive_content(t.coefficient)}).node(),
                        t.coefficient.is_negative() ? -1 : 1));
      }
    }
    return all;
  }
  monomial independent_angle(int node, int sign) { return {{~node, sign * parts_of_angle}}; }

  /// The factors of an angle; null for an independent angle.
  const monomial* factors_of(int node) const {
    const auto known = factors_.find(node);
    return known == factors_.end() ? nullptr : &known->second;
  }

  /// The polynomial expressed in sines and cosines of sums, which are treated as symbols. The input must be
  /// real: every exponential must occur together with its conjugate.
  real_polynomial to_sines_and_cosines(const trigonometric_polynomial& p) {
    term_sum<rational> sum;
    for (const term<gaussian>& t : p.terms) {
      monomial angle, others;
      for (const factor& f : t.factors) (f.base < 0 ? angle : others).push_back(f);
      if (angle.empty()) sum.add(others, t.coefficient.real);
      if (angle.empty() || angle.front().exponent < 0) continue;
      const auto& [sine, cosine] = functions_of(angle);
      add(sum, others, t.coefficient.real * rational(2), cosine);
      add(sum, others, t.coefficient.imaginary * rational(-2), sine);
    }
    return sum.sorted();
  }

private:
  struct functions {
    real_polynomial sine, cosine; ///< terms with one factor, or numbers
  };

  static void add(term_sum<rational>& sum, const monomial& others, const rational& c,
                  const real_polynomial& f) {
    for (const term<rational>& t : f.terms)
      if (!c.is_zero()) sum.add(times(others, t.factors), c * t.coefficient);
  }

  const functions& functions_of(const monomial& angle) {
    const auto known = functions_.find(angle);
    if (known != functions_.end()) return known->second;
    real_polynomial sum;
    for (const factor& f : angle)
      sum = sum + scaled(atom<rational>({g_, ~f.base}), {integer(f.exponent), integer(parts_of_angle)});
    const bool negative = has_negative_leading_term(g_, sum);
    const unsigned_argument argument{to_expression(g_, negative ? -sum : sum), negative};
    return functions_
        .emplace(angle, functions{function_of<rational>(operation::sin, argument, argument),
                                  function_of<rational>(operation::cos, argument, argument)})
        .first->second;
  }

  graph& g_;
  std::map<int, monomial> factors_{};
  std::map<monomial, functions, descending> functions_{};
};

} // namespace kanexpr::symbolic::algebra
