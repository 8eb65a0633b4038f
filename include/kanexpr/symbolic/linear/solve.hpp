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

namespace detail {

/// A symmetric matrix on its way through elimination, by nodes and in both triangles, with the number of
/// entries off the diagonal of each row that is left. Compilers interpret every call, so it is arrays.
struct symmetric_elimination {
  int n;
  sequence<int> entries;
  sequence<int> row_degrees;
  int* entry;  ///< by rows
  int* degree; ///< by row

  /// From the lower triangle.
  constexpr explicit symmetric_elimination(const matrix& m)
      : n(m.rows), entries(n * n, graph::zero), row_degrees(n, 0), entry(entries.begin()),
        degree(row_degrees.begin()) {
    const expression* const given = m.entries.begin();
    for (int i = 0; i < n; ++i)
      for (int j = 0; j <= i; ++j) {
        const int id = given[i * n + j].node();
        entry[i * n + j] = entry[j * n + i] = id;
        if (id != graph::zero && i != j) ++degree[i], ++degree[j];
      }
  }
  symmetric_elimination(const symmetric_elimination&) = delete;
  symmetric_elimination& operator=(const symmetric_elimination&) = delete;

  constexpr void set(int i, int j, int id) {
    const bool was = entry[i * n + j] != graph::zero, is = id != graph::zero;
    entry[i * n + j] = entry[j * n + i] = id;
    if (i == j || was == is) return;
    const int change = is ? 1 : -1;
    degree[i] += change, degree[j] += change;
  }
};

} // namespace detail

/// Solves the symmetric positive definite system M x = f by M = LᵀDL without square roots.
///
/// The order of elimination keeps structural zeros (minimum degree; among equals the last row first, which
/// runs a chain from its tip to its base). Only the lower triangle of M is read.
constexpr symmetric_solution solve_symmetric(graph& g, const matrix& m, const sequence<expression>& f) {
  const int n = m.rows;
  detail::symmetric_elimination left(m);
  int* const entry = left.entry;
  const auto pivot_at = [&](int p, int quotient, sequence<pivot>& all) {
    detail::note_pivot(all, p, {g, quotient}, {g, entry[p * n + p]}, m(p, p));
  };
  sequence<pivot> pivots;
  sequence<int> order, right = nodes_of(f);
  sequence<int> is_eliminated(n, 0), inverses(n, graph::zero), factors(n * n, graph::zero);
  int* const eliminated = is_eliminated.begin();
  int* const factor = factors.begin(); // row p: the multipliers of pivot p
  for (int step = 0; step < n; ++step) {
    int p = -1, least = n + 1;
    for (int i = n - 1; i >= 0; --i)
      if (eliminated[i] == 0 && left.degree[i] < least) p = i, least = left.degree[i];
    eliminated[p] = 1;
    order.push(p);
    int inverse = graph::zero;
    if (least > 0) {
      inverses[p] = inverse = divide(g, graph::one, entry[p * n + p]);
      pivot_at(p, inverse, pivots);
    }
    for (int i = n - 1; i >= 0; --i) {
      if (eliminated[i] != 0 || entry[p * n + i] == graph::zero) continue;
      --left.degree[i];
      const int by = factor[p * n + i] = multiply(g, entry[p * n + i], inverse);
      for (int j = i; j >= 0; --j)
        if (eliminated[j] == 0 && entry[p * n + j] != graph::zero)
          left.set(i, j, subtract(g, entry[i * n + j], multiply(g, by, entry[p * n + j])));
      right[i] = subtract(g, right[i], multiply(g, by, right[p]));
    }
  }
  sequence<int> x(n, graph::zero);
  for (int step = n - 1; step >= 0; --step) {
    const int p = order[step];
    int sum = graph::zero;
    if (inverses[p] == graph::zero) { // coupled to nothing that is left: one division does
      sum = divide(g, right[p], entry[p * n + p]);
      pivot_at(p, sum, pivots);
    } else {
      sum = multiply(g, right[p], inverses[p]);
    }
    for (int i = 0; i < n; ++i)
      if (factor[p * n + i] != graph::zero) sum = subtract(g, sum, multiply(g, factor[p * n + i], x[i]));
    x[p] = sum;
  }
  symmetric_solution solved;
  for (int id : x) solved.x.push({g, id});
  solved.pivots = pivots;
  return solved;
}

} // namespace kanexpr::symbolic
