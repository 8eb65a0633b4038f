#pragma once

#include <kanexpr/symbolic/algebra/trigonometric_form.hpp>
#include <kanexpr/symbolic/graph/evaluate.hpp>

#include <random>

namespace kanexpr::symbolic {

enum class equality {
  equal,     ///< wherever both are defined: this is proved
  different, ///< somewhere: proved, or seen clearly in numbers
  undecided,
};

namespace algebra {

/// Whether the values of two expressions are far apart at every one of a few random states at which both are
/// defined: what rounding does is far less.
inline bool are_seen_apart(const graph& g, const sequence<int>& both) {
  constexpr int wanted = 3, tries = 40;
  constexpr double apart = 1e-4;
  evaluation values(g, both);
  std::mt19937_64 random(20240229);
  std::uniform_real_distribution<double> any(0.3, 1.4);
  int seen = 0;
  for (int i = 0; i < tries && seen < wanted; ++i) {
    std::map<int, double> state;
    values.at([&](int id) { return state.try_emplace(id, any(random)).first->second; });
    const double a = values[both[0]], b = values[both[1]];
    if (!elementary::detail::is_finite(a) || !elementary::detail::is_finite(b)) continue;
    if (elementary::abs(a - b) <= apart * (elementary::abs(a) + elementary::abs(b))) return false;
    ++seen;
  }
  return seen == wanted;
}

} // namespace algebra

/// Whether two expressions have the same value everywhere. Polynomials in symbols and in sines, cosines and
/// tangents of sums of angles, and quotients of these, are always decided, if there are not too many terms.
///
/// Other functions are taken as symbols, but for squares of square roots: what is equal then is equal. Where
/// their relations might matter, and where there are too many terms, numbers decide whether it is different;
/// if they do not, as for abs(x) and x, it is undecided. Decimal numbers are what their bits say: 0.1 is not
/// 1/10.
inline equality compare(expression a, expression b, std::size_t most_terms = usual_most_terms) {
  if (a == b) return equality::equal;
  graph& g = a.owner();
  const sequence<int> both{a.node(), b.node()};
  algebra::budget left(most_terms);
  algebra::trigonometric_reader reader(g, left);
  const auto fractions = reader.read(both);
  if (!left.failed()) {
    algebra::fraction_arithmetic<algebra::gaussian>& arithmetic = reader.arithmetic();
    const auto difference = arithmetic.sum(fractions[0], arithmetic.negative(fractions[1]));
    if (!left.failed() && difference.above.is_zero()) return equality::equal;
    if (!left.failed() && !reader.holds_unknown(difference.above)) return equality::different;
  }
  return algebra::are_seen_apart(g, both) ? equality::different : equality::undecided;
}

/// Whether two expressions are proved to have the same value everywhere; `compare` tells what is different
/// from what is not known.
inline bool are_equal(expression a, expression b, std::size_t most_terms = usual_most_terms) {
  return compare(a, b, most_terms) == equality::equal;
}

} // namespace kanexpr::symbolic
