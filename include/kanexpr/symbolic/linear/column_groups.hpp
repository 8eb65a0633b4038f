#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>

namespace kanexpr::symbolic {

/// Columns of right-hand sides that are solved together.
struct column_group {
  sequence<int> columns{};
  sequence<char> filled{}; ///< the rows in which the reduced right-hand side of any column is nonzero
  int steps = 0;           ///< for each column
};

/// Groups the columns of right-hand sides by the rows in which they become nonzero, so that the steps on
/// zeros are omitted for a whole group. Groups are joined if this adds few steps: a processor takes several
/// columns at a time.
class column_groups {
public:
  /// `factors` has the multipliers of each pivot in a row; `pivots` are in the order of elimination.
  constexpr column_groups(int order, const sequence<int>& pivots, const sequence<int>& factors)
      : n_(order), pivots_(pivots), first_(order + 1, 0) {
    for (int p = 0; p < n_; ++p) {
      first_[p] = rows_.size();
      for (int i = 0; i < n_; ++i)
        if (factors[p * n_ + i] != graph::zero) rows_.push(i);
    }
    first_[n_] = rows_.size();
  }

  constexpr sequence<column_group> of(const matrix& right, const sequence<int>& columns) const {
    sequence<column_group> groups;
    for (int j : columns) {
      column_group added{{j}, sequence<char>(n_, 0)};
      for (int i = 0; i < n_; ++i) added.filled[i] = right(i, j).is_zero() ? 0 : 1;
      fill(added);
      bool is_new = true;
      for (column_group& each : groups) is_new = is_new && !join(each, added, false);
      if (is_new) groups.push(added);
    }
    for (int i = groups.size() - 1; i > 0; --i)
      for (int k = 0; k < i; ++k)
        if (join(groups[k], groups[i], true)) {
          groups[i] = groups.back();
          groups.pop();
          break;
        }
    return groups;
  }

private:
  static constexpr int fewest_per_added = 8; ///< steps for which one may be added

  /// Completes the rows that become nonzero, and counts the steps.
  constexpr void fill(column_group& group) const {
    const int *const rows = rows_.begin(), *const first = first_.begin();
    char* const filled = group.filled.begin();
    int steps = n_ + rows_.size();
    for (int p : pivots_) {
      if (filled[p] == 0) continue;
      const int begin = first[p], end = first[p + 1];
      steps += end - begin;
      for (int k = begin; k < end; ++k) filled[rows[k]] = 1;
    }
    group.steps = steps;
  }

  /// Joins two groups unless this adds steps, or too many.
  constexpr bool join(column_group& one, const column_group& other, bool may_add) const {
    column_group both{one.columns, one.filled};
    both.columns.append(other.columns);
    for (int i = 0; i < n_; ++i)
      if (other.filled[i] != 0) both.filled[i] = 1;
    fill(both);
    const int apart = one.steps * one.columns.size() + other.steps * other.columns.size(),
              together = both.steps * both.columns.size();
    if (together > apart + (may_add ? apart / fewest_per_added : 0)) return false;
    one = both;
    return true;
  }

  int n_;
  const sequence<int>& pivots_;
  sequence<int> rows_{}, first_; ///< the rows with a multiplier of each pivot, and the first one by pivot
};

} // namespace kanexpr::symbolic
