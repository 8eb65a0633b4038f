#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/cost.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/linear/solve.hpp>

namespace kanexpr::symbolic {

/// Adds the elimination of one unknown that is coupled to `others` of the remaining ones.
constexpr void count_elimination(cost& total, int others) {
  total.count(operation::divide);
  if (others == 0) return;
  const int updates = others * (others + 1) / 2 + 2 * others; // of M, of f and of x
  total.count(operation::multiply, updates + others + 1);
  total.count(operation::subtract, updates);
  total.fused += updates;
}

/// The cost of solving M x = f by `symmetric_factorization`, from the pattern of zeros of M only: neither M
/// nor f are included, and every entry of f counts as nonzero.
constexpr cost elimination_cost(const matrix& m) {
  detail::symmetric_elimination left(m);
  const int n = left.n;
  sequence<int> positions(n, -1);
  cost total;
  for (int step = 0; step < n; ++step) {
    const int p = left.next(positions), others = left.degree[p];
    positions[p] = step;
    count_elimination(total, others);
    for (int i = 0; i < n; ++i) {
      if (positions[i] >= 0 || left.entry[p * n + i] == graph::zero) continue;
      --left.degree[i];
      for (int j = 0; j < i; ++j)
        if (positions[j] < 0 && left.entry[p * n + j] != graph::zero) left.set(i, j, graph::one);
    }
  }
  return total;
}

} // namespace kanexpr::symbolic
