#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/numeric/all_finite.hpp>
#include <kanexpr/numeric/independent_columns.hpp>

#include <Eigen/Core>
#include <string>
#include <vector>

namespace kanexpr {

/// The result of checking whether the velocity constraints are independent at a state.
struct independence {
  int rank = 0;
  std::vector<int>
      repeated{}; ///< rows of the constraint Jacobian that depend on preceding ones, counted from 1
  base::sentence failure{};

  explicit operator bool() const { return !failure; }
  /// Returns a message that names the dependent constraint; empty if there is none.
  std::string cause() const { return std::string(failure.view()); }
};

namespace numeric {

/// Checks the rows of a Jacobian in order. Redundant constraints follow the first `solved` rows. The function
/// is a template so that files that do not call it do not instantiate its matrices.
template <class Jacobian>
independence independence_of(const Jacobian& jacobian, Eigen::Index solved, double least) {
  independence found;
  if (!all_finite(jacobian)) {
    found.failure = base::sentence({"the velocity constraints are not finite at this state"});
    return found;
  }
  const independent_columns rows = independent_columns_of(jacobian.transpose(), least);
  found.rank = static_cast<int>(rows.kept.size());
  std::size_t next = 0;
  for (int i = 0; i < jacobian.rows(); ++i)
    if (next < rows.kept.size() && rows.kept[next] == i)
      ++next;
    else
      found.repeated.push_back(i + 1);
  if (found.repeated.empty()) return found;
  const int first = found.repeated[0], redundant = first - static_cast<int>(solved);
  found.failure = redundant > 0 ? base::sentence({"redundant constraint ", base::counted(redundant).view(),
                                                  " depends on other constraints at this state"})
                                : base::sentence({"velocity constraint ", base::counted(first).view(),
                                                  " depends on other constraints at this state"});
  return found;
}
template <class Jacobian>
independence independence_of(const Jacobian& jacobian) {
  return independence_of(jacobian, jacobian.rows(), 1e-9);
}

} // namespace numeric

} // namespace kanexpr
