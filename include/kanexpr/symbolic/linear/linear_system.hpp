#pragma once

#include <kanexpr/symbolic/graph/matrix.hpp>

/// Linear systems as nodes of the graph: one factorization serves any number of right sides, transposed
/// systems, and all derivatives.
namespace kanexpr::symbolic {

constexpr sequence<int> nodes_of(const sequence<expression>& all) {
  sequence<int> nodes;
  for (const expression& e : all) nodes.push(e.node());
  return nodes;
}

/// A square matrix made ready to solve with; no value, but what `solve` and `singularity_measure` need.
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

/// x in A x = b.
constexpr sequence<expression> solve(expression factorization, const sequence<expression>& b) {
  return solve(operation::solve, factorization, b);
}
/// x in Aᵀ x = b.
constexpr sequence<expression> solve_transposed(expression factorization, const sequence<expression>& b) {
  return solve(operation::transposed_solve, factorization, b);
}

/// How far a matrix is from a singular one: of order 1 to 3 |det|, beyond the least pivot of elimination
/// beside the terms that it is the sum of, if the entries are as large as the roots of `squares`, by rows.
/// Zero, or no number, where it is singular. Derivatives take it as a constant.
constexpr expression singularity_measure(expression factorization, const sequence<expression>& squares) {
  graph& g = factorization.owner();
  return {g, singularity_measure(g, factorization.node(), list_of(g, nodes_of(squares)))};
}

} // namespace kanexpr::symbolic
