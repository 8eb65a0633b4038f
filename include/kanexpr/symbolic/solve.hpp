#pragma once

#include <kanexpr/symbolic/expression.hpp>

namespace kanexpr::symbolic {

/// A dense matrix of expressions by rows.
struct matrix {
  int rows = 0;
  int columns = 0;
  sequence<expression> entries;

  constexpr matrix() = default;
  constexpr matrix(graph& g, int rows_, int columns_)
      : rows(rows_), columns(columns_), entries(rows_ * columns_, expression{g, graph::zero}) {}

  constexpr expression& operator()(int i, int j) { return entries[i * columns + j]; }
  constexpr const expression& operator()(int i, int j) const { return entries[i * columns + j]; }
};

/// The determinant by minors of the last rows, each formed once: n 2^(n-1) products, no division and no
/// pivot, so it holds at every state at which the matrix has one. Meant for small n.
constexpr expression determinant(graph& g, const matrix& a) {
  const int n = a.rows;
  sequence<expression> minors(1 << n, expression{g, graph::zero}); // by the set of columns they use
  minors[0] = expression{g, graph::one};
  for (int set = 1; set < (1 << n); ++set) {
    int order = 0;
    for (int j = 0; j < n; ++j) order += (set >> j) & 1;
    const int row = n - order;
    expression sum{g, graph::zero};
    bool plus = true;
    for (int j = 0; j < n; ++j) {
      if (((set >> j) & 1) == 0) continue;
      const expression term = a(row, j) * minors[set & ~(1 << j)];
      sum = plus ? sum + term : sum - term;
      plus = !plus;
    }
    minors[set] = sum;
  }
  return minors[(1 << n) - 1];
}

/// Solves A x = b by Cramer's rule; `b` and the result are of A's order. A vanishing determinant is left to
/// the caller to find out beforehand.
constexpr sequence<expression> solve_by_cofactors(graph& g, const matrix& a, const sequence<expression>& b) {
  const expression below = determinant(g, a);
  sequence<expression> x;
  for (int j = 0; j < a.columns; ++j) {
    matrix replaced = a;
    for (int i = 0; i < a.rows; ++i) replaced(i, j) = b[i];
    x.push(determinant(g, replaced) / below);
  }
  return x;
}

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
