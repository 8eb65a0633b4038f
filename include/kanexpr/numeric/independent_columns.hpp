#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace kanexpr::numeric {

/// The columns of a matrix that do not follow from those before them, and how the others do.
struct independent_columns {
  std::vector<Eigen::Index> kept{};
  Eigen::MatrixXd combination{}; ///< K in A = A_kept K
  /// Beside the length of a column: the shortest remainder that counts, and the longest that does not. Far
  /// apart they tell that the choice is sure. A column too short beside the longest leaves it unsure.
  double shortest_kept = 1, longest_left = 0;
};

/// By the Gram-Schmidt process in the order of the columns, every vector made orthogonal twice (Golub & Van
/// Loan, Matrix Computations, section 5.2). Of columns of length 1, a remainder no longer than `least` counts
/// as nothing, and so does a coefficient. A template, so that files which do not ask for it do not form its
/// matrices.
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
    if (length(j) <= least * longest) { // rounding, or a column in other units
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
