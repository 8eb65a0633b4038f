#pragma once

#include <kanexpr/base/sequence.hpp>

namespace kanexpr::symbolic {

using base::sequence;

/// Rows of a linear system and the same number of unknowns, which they determine given the preceding blocks.
struct diagonal_block {
  sequence<int> rows{};
  sequence<int> columns{};
};

/// Permutes a square system to block triangular form from its sparsity pattern, by a matching of equations
/// with unknowns and the strongly connected components of the resulting dependencies (Duff & Reid, "An
/// implementation of Tarjan's algorithm for the block triangularization of a matrix", 1978).
class block_triangular_form {
public:
  /// `columns_of_row[i]` lists the unknowns in equation i.
  constexpr explicit block_triangular_form(const sequence<sequence<int>>& columns_of_row)
      : columns_(columns_of_row), n_(columns_of_row.size()), row_of_(n_, none), visited_(n_, 0) {
    for (int i = 0; i < n_; ++i) {
      for (char& v : visited_) v = 0;
      matched_ += matches(i) ? 1 : 0;
    }
    number_.resize(n_, none), least_.resize(n_, none), is_open_.resize(n_, 0);
    for (int j = 0; j < n_; ++j)
      if (row_of_[j] != none && number_[j] == none) visit(j);
  }

  /// Whether all equations and unknowns can be paired; if not, the matrix is structurally singular.
  constexpr bool is_regular() const { return matched_ == n_; }
  /// The blocks in solution order, without the unknowns that have no equation.
  constexpr const sequence<diagonal_block>& parts() const { return parts_; }

private:
  static constexpr int none = -1;

  /// Finds a column for a row; reassigns the columns of other rows if necessary.
  constexpr bool matches(int row) {
    for (int j : columns_[row]) {
      if (visited_[j] != 0) continue;
      visited_[j] = 1;
      if (row_of_[j] != none && !matches(row_of_[j])) continue;
      row_of_[j] = row;
      return true;
    }
    return false;
  }

  constexpr void visit(int column) {
    number_[column] = least_[column] = count_++;
    open_.push(column);
    is_open_[column] = 1;
    for (int j : columns_[row_of_[column]]) {
      if (row_of_[j] == none) continue;
      if (number_[j] == none) visit(j);
      if (is_open_[j] != 0 && least_[j] < least_[column]) least_[column] = least_[j];
    }
    if (least_[column] != number_[column]) return;
    diagonal_block part;
    for (int j = none; j != column;) {
      j = open_.back();
      open_.pop();
      is_open_[j] = 0;
      insert(part.columns, j);
      insert(part.rows, row_of_[j]);
    }
    parts_.push(part);
  }

  static constexpr void insert(sequence<int>& ascending, int value) {
    int place = ascending.push(value);
    for (; place > 0 && ascending[place - 1] > value; --place) ascending[place] = ascending[place - 1];
    ascending[place] = value;
  }

  const sequence<sequence<int>>& columns_;
  int n_ = 0;
  int matched_ = 0;
  int count_ = 0;
  sequence<int> row_of_; ///< the row matched to each column
  sequence<char> visited_;
  sequence<int> number_{}, least_{}; ///< numbers of columns, in order of discovery
  sequence<int> open_{};
  sequence<char> is_open_{};
  sequence<diagonal_block> parts_{};
};

} // namespace kanexpr::symbolic
