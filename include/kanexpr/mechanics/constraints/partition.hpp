#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/motion/generic_states.hpp>

namespace kanexpr::mechanics {

/// The unknowns for which equations are solved, and those that remain free; both in the order of the model.
struct partition {
  sequence<int> dependent{};
  sequence<int> independent{};

  /// The dependent unknowns in the given columns of equations that are solved for all of them.
  constexpr sequence<int> dependent_in(const sequence<int>& columns) const {
    sequence<int> places;
    for (const int column : columns) places.push(dependent[column]);
    return places;
  }
};

constexpr partition partition_by(const sequence<char>& is_dependent) {
  partition p;
  for (int j = 0; j < is_dependent.size(); ++j)
    is_dependent[j] != 0 ? p.dependent.push(j) : p.independent.push(j);
  return p;
}

namespace detail {

/// Gaussian elimination with full pivoting at several states simultaneously.
class choice_by_elimination {
public:
  constexpr choice_by_elimination(const sequence<numbers>& states, const symbolic::matrix& jacobian,
                                  const sequence<char>& preferred)
      : jacobian_(jacobian), preferred_(preferred), states_(states), row_done_(jacobian.rows, 0),
        is_dependent_(jacobian.columns, 0) {}

  constexpr partition run() {
    for (int step = 0; step < jacobian_.rows; ++step) {
      place pivot = best(false);
      if (pivot.row == none) pivot = best(true); // include the fill-in
      if (pivot.row == none) break;              // a singular constraint, already reported by a check
      row_done_[pivot.row] = 1;
      is_dependent_[pivot.column] = 1;
      for (numbers& a : states_) eliminate(a, pivot);
    }
    return partition_by(is_dependent_);
  }

private:
  struct place {
    int row = none;
    int column = none;
  };

  static constexpr double rounding = 1e-13; ///< relative to entries of order 1
  static constexpr double magnitude(double x) { return x < 0 ? -x : x; }

  /// The best pivot among the entries of the Jacobian; if `takes_all`, also among the fill-in.
  constexpr place best(bool takes_all) const {
    sequence<int> in_row(jacobian_.rows, 0), in_column(jacobian_.columns, 0); // remaining entries
    sequence<double> largest(states_.size() * jacobian_.rows, 0.0);
    for (int i = 0; i < jacobian_.rows; ++i)
      for (int j = 0; j < jacobian_.columns && row_done_[i] == 0; ++j) {
        if (is_dependent_[j] != 0) continue;
        if (takes_all || !jacobian_(i, j).is_zero()) ++in_row[i], ++in_column[j];
        for (int s = 0; s < states_.size(); ++s) {
          double& l = largest[s * jacobian_.rows + i];
          if (magnitude(states_[s](i, j)) > l) l = magnitude(states_[s](i, j));
        }
      }
    place found;
    double most = 0;
    for (int i = 0; i < jacobian_.rows; ++i)
      for (int j = 0; j < jacobian_.columns && row_done_[i] == 0; ++j) {
        if (is_dependent_[j] != 0) continue;
        if (!takes_all && jacobian_(i, j).is_zero()) continue;
        double least = 1; // smallest ratio, over the states, of the entry to the largest in its row
        for (int s = 0; s < states_.size(); ++s) {
          const double l = largest[s * jacobian_.rows + i];
          const double ratio = l > rounding ? magnitude(states_[s](i, j)) / l : 0;
          if (ratio < least) least = ratio;
        }
        double value = least / (in_row[i] + in_column[j]);
        if (preferred_[j] != 0) value *= 4;
        if (value > most * (1 + 1e-9)) most = value, found = {i, j};
      }
    return found;
  }

  constexpr void eliminate(numbers& a, place pivot) const {
    for (int i = 0; i < a.rows; ++i) {
      if (row_done_[i] != 0 || base::equal(a(i, pivot.column), 0.0)) continue;
      const double factor = a(i, pivot.column) / a(pivot.row, pivot.column);
      for (int j = 0; j < a.columns; ++j) a.entries[i * a.columns + j] -= factor * a(pivot.row, j);
    }
  }

  const symbolic::matrix& jacobian_;
  const sequence<char>& preferred_;
  sequence<numbers> states_;
  sequence<char> row_done_, is_dependent_;
};

} // namespace detail

/// Chooses dependent unknowns among the columns of a Jacobian, one for each row, by elimination with full
/// pivoting at several generic states simultaneously, so that the choice is well conditioned at all of them.
/// Columns and rows with few entries have a larger weight, which makes the solution cheap (Markowitz).
/// `preferred` columns are chosen if they are nearly as good.
constexpr partition choose_dependent(const sequence<numbers>& states, const symbolic::matrix& jacobian,
                                     const sequence<char>& preferred) {
  return detail::choice_by_elimination(states, jacobian, preferred).run();
}

/// The dependent unknowns chosen by the user, or else by `choose_dependent`.
constexpr partition partition_of(const sequence<numbers>& states, const symbolic::matrix& jacobian,
                                 const sequence<int>& chosen, const sequence<char>& preferred) {
  if (chosen.empty()) return choose_dependent(states, jacobian, preferred);
  sequence<char> is_dependent(jacobian.columns, 0);
  for (int j : chosen) is_dependent[j] = 1;
  return partition_by(is_dependent);
}

} // namespace kanexpr::mechanics
