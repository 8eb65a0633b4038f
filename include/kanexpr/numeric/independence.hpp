#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/numeric/all_finite.hpp>
#include <kanexpr/numeric/independent_columns.hpp>

#include <string>
#include <vector>

namespace kanexpr {

/// Whether the constraints on the speeds are independent at a state.
struct independence {
  int rank = 0;
  std::vector<int>
      repeated{}; ///< rows of the constraint Jacobian that follow from those before them, from 1 on
  mechanics::sentence failure{};

  explicit operator bool() const { return !failure; }
  /// Which constraint repeats others, as a sentence; empty: none.
  std::string cause() const { return std::string(failure.view()); }
};

namespace numeric {

/// Of the rows of a Jacobian, in their order. Behind the first `solved` of them come redundant constraints. A
/// template, so that files which do not ask for it do not form its matrices.
template <class Jacobian>
independence independence_of(const Jacobian& jacobian, Eigen::Index solved, double least) {
  independence found;
  if (!all_finite(jacobian)) {
    found.failure = mechanics::sentence({"the constraints on the speeds are not finite at this state"});
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
  found.failure = redundant > 0
                      ? mechanics::sentence({"redundant constraint ", mechanics::counted(redundant).view(),
                                             " repeats others here"})
                      : mechanics::sentence({"constraint ", mechanics::counted(first).view(),
                                             " on the speeds repeats others here"});
  return found;
}
template <class Jacobian>
independence independence_of(const Jacobian& jacobian) {
  return independence_of(jacobian, jacobian.rows(), 1e-9);
}

} // namespace numeric

} // namespace kanexpr
