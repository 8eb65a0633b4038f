#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/derivatives/accumulate.hpp>
#include <kanexpr/symbolic/derivatives/dependence.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/linear/linear_system.hpp>

namespace kanexpr::symbolic {

/// The derivatives of expressions (rows) with respect to symbols (columns), column by column by forward
/// differentiation.
constexpr matrix forward_jacobian(graph& g, const sequence<expression>& of, const sequence<expression>& by) {
  matrix all(g, of.size(), by.size());
  if (all.entries.empty()) return all;
  const sequence<int> nodes = nodes_of(of);
  dependence found(g, nodes, by.size());
  for (int j = 0; j < all.columns; ++j) found.mark(by[j].node(), j);
  found.spread();
  const dependence::word* const changes = found.begin(); // as compilers interpret each call
  const int* const rows = nodes.begin();
  const int words = found.words(), count = all.rows;
  for (int j = 0; j < all.columns; ++j) {
    differentiation along(g);
    along.set_rate(by[j], {g, graph::one});
    along.skip_unchanged(found, j);
    for (int i = 0; i < count; ++i)
      if ((changes[rows[i] * words + j / 64] >> (j % 64) & 1) != 0) all(i, j) = along.of(of[i]);
  }
  return all;
}

/// The derivatives of expressions (rows) with respect to symbols (columns): column by column by forward
/// differentiation, or row by row by reverse accumulation if there are fewer rows.
constexpr matrix jacobian(graph& g, const sequence<expression>& of, const sequence<expression>& by) {
  if (of.size() >= by.size()) return forward_jacobian(g, of, by);
  matrix all(g, of.size(), by.size());
  if (of.empty()) return all;
  accumulation back(g, of);
  for (int i = 0; i < all.rows; ++i) {
    back.restart();
    back.seed(of[i], {g, graph::one});
    back.run();
    for (int j = 0; j < all.columns; ++j) all(i, j) = back.by(by[j]);
  }
  return all;
}

} // namespace kanexpr::symbolic
