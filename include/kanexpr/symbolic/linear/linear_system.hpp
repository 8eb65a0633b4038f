#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

/// Linear systems as nodes of the graph: one factorization serves any number of right-hand sides, transposed
/// systems and all derivatives.
namespace kanexpr::symbolic {

/// A factorized square matrix; not a value, only an operand of `solve` and `singularity_measure`.
constexpr expression factorization(graph& g, const matrix& a) {
  return {g, factorization(g, nodes_of(a.entries), a.rows)};
}

constexpr sequence<expression> solve(operation op, expression factorization, const sequence<expression>& b) {
  graph& g = factorization.owner();
  const int all = solution(g, op, factorization.node(), list_of(g, nodes_of(b)));
  sequence<expression> x;
  for (int i = 0; i < b.size(); ++i) x.push({g, component(g, all, i)});
  return x;
}

/// Solves A x = b.
constexpr sequence<expression> solve(expression factorization, const sequence<expression>& b) {
  return solve(operation::solve, factorization, b);
}
/// Solves Aᵀ x = b.
constexpr sequence<expression> solve_transposed(expression factorization, const sequence<expression>& b) {
  return solve(operation::transposed_solve, factorization, b);
}

/// The distance of a matrix from singularity: |det| for orders 1 to 3; for larger orders, the smallest pivot
/// of the elimination relative to the terms that add up to it. `squares` contains the squared sizes of the
/// entries, row by row. The measure is zero or NaN if the matrix is singular. Derivatives treat it as a
/// constant.
constexpr expression singularity_measure(expression factorization, const sequence<expression>& squares) {
  graph& g = factorization.owner();
  return {g, singularity_measure(g, factorization.node(), list_of(g, nodes_of(squares)))};
}

} // namespace kanexpr::symbolic
