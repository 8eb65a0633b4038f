#pragma once

#include <kanexpr/symbolic/matrix.hpp>
#include <kanexpr/symbolic/solve_linear.hpp>

namespace kanexpr::symbolic {

/// Solves the symmetric positive definite system M x = f by M = LᵀDL without square roots.
///
/// The order of elimination keeps structural zeros (minimum degree; among equals the last row first, which
/// runs a chain from its tip to its base). Only the lower triangle of M is read.
constexpr sequence<expression> solve_symmetric(graph& g, matrix m, sequence<expression> f) {
  const int n = m.rows;
  const auto at = [&](int i, int j) -> expression& { return i >= j ? m(i, j) : m(j, i); };
  sequence<int> order;
  sequence<int> eliminated(n, 0);
  sequence<expression> inverse(n, expression{g, graph::zero});
  matrix factor(g, n, n); // row p: the multipliers of pivot p
  for (int step = 0; step < n; ++step) {
    int pivot = -1, least = n + 1;
    for (int i = n - 1; i >= 0; --i) {
      if (eliminated[i] != 0) continue;
      int degree = 0;
      for (int j = 0; j < n; ++j)
        if (j != i && eliminated[j] == 0 && !at(i, j).is_zero()) ++degree;
      if (degree < least) pivot = i, least = degree;
    }
    eliminated[pivot] = 1;
    order.push(pivot);
    if (least > 0) inverse[pivot] = 1 / at(pivot, pivot);
    for (int i = n - 1; i >= 0; --i) {
      if (eliminated[i] != 0 || at(pivot, i).is_zero()) continue;
      factor(pivot, i) = at(pivot, i) * inverse[pivot];
      for (int j = i; j >= 0; --j)
        if (eliminated[j] == 0 && !at(pivot, j).is_zero()) at(i, j) -= factor(pivot, i) * at(pivot, j);
      f[i] -= factor(pivot, i) * f[pivot];
    }
  }
  sequence<expression> x(n, expression{g, graph::zero});
  for (int step = n - 1; step >= 0; --step) {
    const int p = order[step];
    if (inverse[p].is_zero()) // coupled to nothing that is left: one division does
      x[p] = f[p] / at(p, p);
    else
      x[p] = f[p] * inverse[p];
    for (int i = 0; i < n; ++i)
      if (!factor(p, i).is_zero()) x[p] -= factor(p, i) * x[i];
  }
  return x;
}

} // namespace kanexpr::symbolic
