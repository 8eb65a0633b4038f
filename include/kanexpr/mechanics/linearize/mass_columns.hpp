#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>
#include <kanexpr/symbolic/linear/solve.hpp>

namespace kanexpr::mechanics {

/// Solves M X = F for the changes of the speeds' rates, a column for each direction of change.
class mass_columns {
public:
  constexpr mass_columns(graph& g, const symbolic::matrix& mass) : g_(g), mass_(g, mass) {}

  constexpr symbolic::matrix solve(const symbolic::matrix& force) {
    symbolic::matrix out(g_, force.rows, force.columns);
    sequence<int> moved, solved; // for each direction, the only speed whose equation it changes; the others
    for (int j = 0; j < out.columns; ++j) {
      moved.push(only_entry(force, j));
      if (moved[j] == none) solved.push(j);
    }
    if (out.rows >= fewest_rows_together && solved.size() >= fewest_columns_together) {
      pivots_.append(mass_.solve_together(force, solved, out));
    } else {
      mass_.prepare_for(force);
      for (int j : solved) solve_column(force, j, out);
    }
    add_columns_of_inverse(force, moved, out);
    return out;
  }

  /// The pivots of these solutions, possibly with duplicates.
  constexpr const sequence<symbolic::pivot>& pivots() const { return pivots_; }

private:
  static constexpr int none = -1;
  /// In larger systems, columns are solved together; in smaller ones, written-out operations are cheaper.
  static constexpr int fewest_rows_together = 5, fewest_columns_together = 8;

  /// The row of the only nonzero entry of a column, or none.
  static constexpr int only_entry(const symbolic::matrix& all, int column) {
    int found = none;
    for (int i = 0; i < all.rows; ++i)
      if (!all(i, column).is_zero()) {
        if (found != none) return none;
        found = i;
      }
    return found;
  }

  constexpr void solve_column(const symbolic::matrix& force, int column, symbolic::matrix& out) {
    sequence<expression> right;
    for (int i = 0; i < out.rows; ++i) right.push(force(i, column));
    const symbolic::symmetric_solution rates = mass_.solve(right);
    for (int i = 0; i < out.rows; ++i) out(i, column) = rates.x[i];
    pivots_.append(rates.pivots);
  }

  /// Adds the rates for directions that change the equation of only one speed, as the torque of a motor does;
  /// these rates are a column of the inverse mass matrix.
  constexpr void add_columns_of_inverse(const symbolic::matrix& force, const sequence<int>& moved,
                                        symbolic::matrix& out) {
    sequence<int> columns;
    for (int i : moved)
      if (i != none && !columns.contains(i)) columns.push(i);
    const sequence<symbolic::symmetric_solution> inverse = mass_.inverse_columns(columns);
    for (const symbolic::symmetric_solution& column : inverse) pivots_.append(column.pivots);
    for (int j = 0; j < out.columns; ++j) {
      if (moved[j] == none) continue;
      const symbolic::symmetric_solution& column = inverse[columns.find(moved[j])];
      for (int i = 0; i < out.rows; ++i) out(i, j) = force(moved[j], j) * column.x[i];
    }
  }

  graph& g_;
  symbolic::symmetric_factorization mass_;
  sequence<symbolic::pivot> pivots_{};
};

} // namespace kanexpr::mechanics
