#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace kanexpr::numeric {

/// The columns of a matrix that are independent of the preceding ones, and the linear combinations of them
/// that give the others.
struct independent_columns {
  std::vector<Eigen::Index> kept{};
  Eigen::MatrixXd combination{}; ///< K in A = A_kept K
  /// The shortest remainder of the columns that were kept and the longest of those that were not, relative to
  /// the length of the column. If they differ by orders of magnitude, the choice is reliable; a column that
  /// is too short compared with the longest makes it unreliable.
  double shortest_kept = 1, longest_left = 0;
};

/// Finds the columns, in order, by the Gram-Schmidt process with reorthogonalization (Golub & Van Loan,
/// Matrix Computations, section 5.2). For columns of length 1, remainders and coefficients of `least` or
/// below are treated as zero. The function is a template so that files that do not call it do not instantiate
/// its matrices.
template <class Matrix>
independent_columns independent_columns_of(const Matrix& given, double least) {
  using matrix = Eigen::Matrix<typename Matrix::Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  using vector = Eigen::Matrix<typename Matrix::Scalar, Eigen::Dynamic, 1>;
  const matrix a = given;
  const Eigen::Index columns = a.cols();
  vector length = a.colwise().norm();
  const double longest = columns == 0 ? 0 : length.maxCoeff();
  matrix q(a.rows(), columns), r = matrix::Zero(columns, columns), by_kept = matrix::Zero(columns, columns);
  independent_columns found;
  for (Eigen::Index j = 0; j < columns; ++j) {
    if (!(length(j) > 0)) continue;
    if (length(j) <= least * longest) { // rounding, or a column in different units
      found.shortest_kept = (std::min)(found.shortest_kept, length(j) / longest);
      continue;
    }
    const Eigen::Index rank = static_cast<Eigen::Index>(found.kept.size());
    vector left = a.col(j) / length(j), along = vector::Zero(rank);
    for (int twice = 0; twice < 2; ++twice)
      for (Eigen::Index i = 0; i < rank; ++i) {
        const double part = q.col(i).dot(left);
        left -= part * q.col(i);
        along(i) += part;
      }
    const double remainder = left.norm();
    if (remainder > least) {
      found.shortest_kept = (std::min)(found.shortest_kept, remainder);
      q.col(rank) = left / remainder;
      r.col(rank).head(rank) = along;
      r(rank, rank) = remainder;
      by_kept(rank, j) = 1;
      found.kept.push_back(j);
      continue;
    }
    found.longest_left = (std::max)(found.longest_left, remainder);
    for (Eigen::Index i = rank; i-- > 0;) {
      along(i) /= r(i, i);
      along.head(i) -= along(i) * r.col(i).head(i);
      const double own = length(found.kept[static_cast<std::size_t>(i)]);
      if (std::abs(along(i)) > least) by_kept(i, j) = along(i) * length(j) / own;
    }
  }
  found.combination = by_kept.topRows(static_cast<Eigen::Index>(found.kept.size()));
  return found;
}

} // namespace kanexpr::numeric
