#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/algebra/equality.hpp>
#include <kanexpr/symbolic/algebra/trigonometric_form.hpp>
#include <kanexpr/symbolic/graph/evaluate.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>

#include <cmath>
#include <map>
#include <random>

namespace kanexpr::symbolic {

namespace algebra {

/// Whether two expressions differ clearly, by much more than rounding errors, at each of several random
/// states where both are defined.
inline bool differ_numerically(const graph& g, const sequence<int>& both) {
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
    if (!is_finite(a) || !is_finite(b)) continue;
    if (std::abs(a - b) <= apart * (std::abs(a) + std::abs(b))) return false;
    ++seen;
  }
  return seen == wanted;
}

} // namespace algebra

KANEXPR_ENGINE equality compare(expression a, expression b, std::size_t most_terms) {
  if (a == b) return equality::equal;
  graph& g = a.owner();
  const sequence<int> both{a.node(), b.node()};
  algebra::budget left(most_terms);
  algebra::trigonometric_reader reader(g, left);
  const auto fractions = reader.read(both);
  if (!left.failed()) {
    const auto difference = reader.sum(fractions[0], reader.negative(fractions[1]));
    if (!left.failed() && difference.numerator.is_zero()) return equality::equal;
    if (!left.failed() && !reader.has_opaque_functions(difference.numerator)) return equality::different;
  }
  return algebra::differ_numerically(g, both) ? equality::different : equality::undecided;
}

KANEXPR_ENGINE bool are_equal(expression a, expression b, std::size_t most_terms) {
  return compare(a, b, most_terms) == equality::equal;
}

} // namespace kanexpr::symbolic
