// Products and linear systems in plain loops, which compile quickly.
#pragma once

#include <Eigen/Core>

#include <cmath>
#include <vector>

namespace elimination {

using Eigen::Index;
using Eigen::MatrixXd;

inline MatrixXd product(const MatrixXd& a, const MatrixXd& b) {
  MatrixXd c = MatrixXd::Zero(a.rows(), b.cols());
  for (Index i = 0; i < a.rows(); ++i)
    for (Index j = 0; j < b.cols(); ++j)
      for (Index k = 0; k < a.cols(); ++k) c(i, j) += a(i, k) * b(k, j);
  return c;
}
inline MatrixXd transposed(const MatrixXd& a) {
  MatrixXd t(a.cols(), a.rows());
  for (Index i = 0; i < a.rows(); ++i)
    for (Index j = 0; j < a.cols(); ++j) t(j, i) = a(i, j);
  return t;
}
inline double largest(const MatrixXd& a) {
  double most = 0;
  for (Index i = 0; i < a.size(); ++i)
    if (!(std::abs(a.data()[i]) <= most)) most = std::abs(a.data()[i]);
  return most;
}

// X in A X = B by Gauss-Jordan elimination with full pivoting; A has at least as many columns as rows, and
// surplus unknowns are zero.
struct solved {
  MatrixXd x;
  double least_pivot = 0;
};

inline solved solve(MatrixXd a, MatrixXd b) {
  solved out{MatrixXd::Zero(a.cols(), b.cols())};
  std::vector<Index> column(static_cast<std::size_t>(a.rows()));
  std::vector<bool> used(static_cast<std::size_t>(a.cols()), false);
  for (Index k = 0; k < a.rows(); ++k) {
    Index row = k, pivot = -1;
    for (Index i = k; i < a.rows(); ++i)
      for (Index j = 0; j < a.cols(); ++j) {
        if (used[static_cast<std::size_t>(j)]) continue;
        if (pivot < 0 || std::abs(a(i, j)) > std::abs(a(row, pivot))) row = i, pivot = j;
      }
    out.least_pivot = std::abs(a(row, pivot));
    if (out.least_pivot == 0) return out;
    for (Index j = 0; j < a.cols(); ++j) std::swap(a(row, j), a(k, j));
    for (Index j = 0; j < b.cols(); ++j) std::swap(b(row, j), b(k, j));
    used[static_cast<std::size_t>(pivot)] = true;
    column[static_cast<std::size_t>(k)] = pivot;
    for (Index i = 0; i < a.rows(); ++i) {
      if (i == k) continue;
      const double factor = a(i, pivot) / a(k, pivot);
      for (Index j = 0; j < a.cols(); ++j) a(i, j) -= factor * a(k, j);
      for (Index j = 0; j < b.cols(); ++j) b(i, j) -= factor * b(k, j);
    }
  }
  for (Index k = 0; k < a.rows(); ++k) {
    const Index j = column[static_cast<std::size_t>(k)];
    for (Index c = 0; c < b.cols(); ++c) out.x(j, c) = b(k, c) / a(k, j);
  }
  return out;
}

} // namespace elimination
