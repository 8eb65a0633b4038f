#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>
#include <kanexpr/symbolic/linear/column_groups.hpp>
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
      if (moved[j] == several) solved.push(j);
    }
    if (out.rows >= fewest_rows_together && solved.size() >= fewest_columns_together) {
      pivots_.append(mass_.solve_together(force, groups_with_inverse(force, solved, moved), out));
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
  static constexpr int none = -1, several = -2;
  /// In larger systems, columns are solved together; in smaller ones, written-out operations are cheaper.
  static constexpr int fewest_rows_together = 5, fewest_columns_together = 8, most_steps_for_one = 3;

  /// The row of the only nonzero entry of a column; none or several.
  static constexpr int only_entry(const symbolic::matrix& all, int column) {
    int found = none;
    for (int i = 0; i < all.rows; ++i)
      if (!all(i, column).is_zero()) found = found == none ? i : several;
    return found;
  }

  /// Groups columns, and adds those of the inverse unless this takes many more steps. On their own, half of
  /// their entries follow by symmetry, and in branched systems they share more of them.
  constexpr sequence<symbolic::column_group> groups_with_inverse(const symbolic::matrix& force,
                                                                 const sequence<int>& solved,
                                                                 sequence<int>& moved) const {
    sequence<int> of_inverse, all;
    for (int j = 0; j < moved.size(); ++j) {
      if (moved[j] >= 0 && !of_inverse.contains(moved[j])) of_inverse.push(moved[j]);
      if (moved[j] != none) all.push(j);
    }
    const sequence<symbolic::column_group> apart = mass_.grouped(force, solved);
    if (of_inverse.empty()) return apart;
    const sequence<symbolic::column_group> together = mass_.grouped(force, all);
    const int added = steps_of(together) - steps_of(apart);
    if (added > most_steps_for_one * mass_.steps_of_inverse(of_inverse)) return apart;
    for (int& row : moved) row = none;
    return together;
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
      if (i >= 0 && !columns.contains(i)) columns.push(i);
    const sequence<symbolic::symmetric_solution> inverse = mass_.inverse_columns(columns);
    for (const symbolic::symmetric_solution& column : inverse) pivots_.append(column.pivots);
    for (int j = 0; j < out.columns; ++j) {
      if (moved[j] < 0) continue;
      const symbolic::symmetric_solution& column = inverse[columns.find(moved[j])];
      for (int i = 0; i < out.rows; ++i) out(i, j) = force(moved[j], j) * column.x[i];
    }
  }

  graph& g_;
  symbolic::symmetric_factorization mass_;
  sequence<symbolic::pivot> pivots_{};
};

} // namespace kanexpr::mechanics
