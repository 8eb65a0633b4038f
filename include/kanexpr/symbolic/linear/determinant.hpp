#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::symbolic {

/// The largest order for which the determinant is expanded; beyond it, the expression would be long.
inline constexpr int largest_with_determinant = 6;

/// The determinant of a matrix stored in row-major order, expanded along its first row. Minors are shared as
/// equal nodes, and structural zeros vanish.
constexpr expression determinant(const sequence<expression>& entries, int order) {
  if (order == 1) return entries[0];
  expression sum = entries[0] - entries[0];
  for (int j = 0; j < order; ++j) {
    if (entries[j].is_zero()) continue;
    sequence<expression> rest;
    for (int i = 1; i < order; ++i)
      for (int k = 0; k < order; ++k)
        if (k != j) rest.push(entries[i * order + k]);
    const expression minor = determinant(rest, order - 1);
    const expression term = entries[j] * minor;
    sum = j % 2 == 0 ? sum + term : sum - term;
  }
  return sum;
}

} // namespace kanexpr::symbolic
