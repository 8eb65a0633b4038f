#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>

namespace kanexpr::symbolic {

/// A dense matrix of expressions, stored in row-major order.
struct matrix {
  int rows = 0;
  int columns = 0;
  sequence<expression> entries{};

  constexpr matrix() = default;
  constexpr matrix(graph& g, int rows_, int columns_)
      : rows(rows_), columns(columns_), entries(rows_ * columns_, expression{g, graph::zero}) {}
  template <class Self, class Visit>
  static constexpr void each_member(Self& self, Visit&& visit) {
    visit(self.rows, self.columns, self.entries);
  }

  constexpr expression& operator()(int i, int j) { return entries[i * columns + j]; }
  constexpr const expression& operator()(int i, int j) const { return entries[i * columns + j]; }
};

constexpr bool is_zero(const matrix& m) {
  for (const expression& e : m.entries)
    if (!e.is_zero()) return false;
  return true;
}

} // namespace kanexpr::symbolic
