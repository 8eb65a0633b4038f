#pragma once

#include <kanexpr/symbolic/graph/matrix.hpp>
#include <kanexpr/symbolic/linear/solve_linear.hpp>

namespace kanexpr::symbolic {

/// What one unknown is divided by when a symmetric matrix is eliminated.
struct pivot {
  int place = 0; ///< of the unknown
  int key = 0;   ///< the divisor
  expression value{};
  expression entry{}; ///< of the diagonal, before anything was taken off it
};

struct symmetric_solution {
  sequence<expression> x{};
  sequence<pivot> pivots{}; ///< not those that are numbers; what spoils others comes before them
};

namespace detail {

/// The pivot that a quotient divides by. A quotient may have been simplified: then its divisor is a factor of
/// the pivot, which is compared with itself.
constexpr void note_pivot(sequence<pivot>& all, int place, expression quotient, expression value,
                          expression entry) {
  graph& g = value.owner();
  const auto unsigned_node = [&](int id) { return g[id].op == operation::negate ? g[id].a : id; };
  const node& divided = g[unsigned_node(quotient.node())];
  if (value.is_constant() || divided.op != operation::divide) return;
  if (divided.b == unsigned_node(value.node()))
    all.push({place, divided.b, value, entry});
  else
    all.push({place, divided.b, {g, divided.b}, {g, divided.b}});
}

} // namespace detail

/// Solves the symmetric positive definite system M x = f by M = LᵀDL without square roots.
///
/// The order of elimination keeps structural zeros (minimum degree; among equals the last row first, which
/// runs a chain from its tip to its base). Only the lower triangle of M is read.
constexpr symmetric_solution solve_symmetric(graph& g, matrix m, sequence<expression> f) {
  const int n = m.rows;
  sequence<expression> diagonal;
  for (int i = 0; i < n; ++i) diagonal.push(m(i, i));
  sequence<pivot> pivots;
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
    if (least > 0) {
      inverse[pivot] = 1 / at(pivot, pivot);
      detail::note_pivot(pivots, pivot, inverse[pivot], at(pivot, pivot), diagonal[pivot]);
    }
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
    if (inverse[p].is_zero()) { // coupled to nothing that is left: one division does
      x[p] = f[p] / at(p, p);
      detail::note_pivot(pivots, p, x[p], at(p, p), diagonal[p]);
    } else {
      x[p] = f[p] * inverse[p];
    }
    for (int i = 0; i < n; ++i)
      if (!factor(p, i).is_zero()) x[p] -= factor(p, i) * x[i];
  }
  return {x, pivots};
}

} // namespace kanexpr::symbolic
