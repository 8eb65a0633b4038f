#pragma once

#include <Eigen/Core>

#include <cmath>
#include <limits>
#include <utility>

namespace kanexpr::numeric {

/// The singular value decomposition A = U Σ Vᵀ, with singular values in descending order. Pairs of rows are
/// rotated until all rows are orthogonal; this also preserves the accuracy of small singular values (Hestenes
/// 1958; Golub & Van Loan, Matrix Computations, 8.6.3). No heap memory is used for a fixed-size matrix.
template <class Matrix>
class singular_values {
  using number = typename Matrix::Scalar;
  static constexpr int rows = Matrix::RowsAtCompileTime, columns = Matrix::ColsAtCompileTime;

public:
  using left = Eigen::Matrix<number, rows, 1>;
  using right = Eigen::Matrix<number, columns, 1>;

  explicit singular_values(Matrix a)
      : u_(Eigen::Matrix<number, rows, rows>::Identity(a.rows(), a.rows())),
        v_(Eigen::Matrix<number, columns, columns>::Zero(a.cols(), a.cols())), sizes_(left::Zero(a.rows())) {
    orthogonalize(a);
    for (Eigen::Index i = 0; i < a.rows(); ++i) sizes_(i) = a.row(i).norm();
    sort(a);
    for (Eigen::Index i = 0; i < count(); ++i)
      if (sizes_(i) > 0) v_.col(i) = a.row(i).transpose() / sizes_(i);
  }

  /// Returns the number of singular values.
  Eigen::Index count() const { return (std::min)(u_.rows(), v_.rows()); }
  number operator[](Eigen::Index i) const { return sizes_(i); }
  /// Returns the number of singular values greater than `least`.
  Eigen::Index rank(number least) const {
    Eigen::Index found = 0;
    while (found < count() && sizes_(found) > least) ++found;
    return found;
  }
  auto left_vector(Eigen::Index i) const { return u_.col(i); }
  auto right_vector(Eigen::Index i) const { return v_.col(i); }

  /// Keeps the first `rank` right vectors and replaces the others by an orthonormal basis of the orthogonal
  /// complement.
  void complete_basis(Eigen::Index rank) {
    for (Eigen::Index k = rank; k < v_.cols(); ++k) {
      Eigen::Index farthest = 0;
      number least = std::numeric_limits<number>::infinity();
      for (Eigen::Index i = 0; i < v_.rows(); ++i) {
        const number taken = v_.row(i).head(k).squaredNorm();
        if (taken < least) farthest = i, least = taken;
      }
      right next = right::Zero(v_.rows());
      next(farthest) = 1;
      for (int twice = 0; twice < 2; ++twice)
        for (Eigen::Index j = 0; j < k; ++j) next -= v_.col(j).dot(next) * v_.col(j);
      v_.col(k) = next / next.norm();
    }
  }

private:
  void orthogonalize(Matrix& a) {
    constexpr number rounding = std::numeric_limits<number>::epsilon();
    bool turned = true;
    for (int sweeps = 0; turned && sweeps < 60; ++sweeps) {
      turned = false;
      for (Eigen::Index i = 0; i < a.rows(); ++i)
        for (Eigen::Index j = i + 1; j < a.rows(); ++j) {
          const number first = a.row(i).squaredNorm(), second = a.row(j).squaredNorm(),
                       both = a.row(i).dot(a.row(j));
          if (!(std::abs(both) > rounding * std::sqrt(first) * std::sqrt(second))) continue;
          const number slope = (second - first) / (2 * both);
          const number t = (slope < 0 ? -1 : 1) / (std::abs(slope) + std::hypot(number(1), slope));
          const number c = 1 / std::hypot(number(1), t);
          turn(a, i, j, c, c * t);
          turned = true;
        }
    }
  }
  void turn(Matrix& a, Eigen::Index i, Eigen::Index j, number c, number s) {
    for (Eigen::Index k = 0; k < a.cols(); ++k) {
      const number before = a(i, k);
      a(i, k) = c * before - s * a(j, k);
      a(j, k) = s * before + c * a(j, k);
    }
    for (Eigen::Index k = 0; k < u_.rows(); ++k) {
      const number before = u_(k, i);
      u_(k, i) = c * before - s * u_(k, j);
      u_(k, j) = s * before + c * u_(k, j);
    }
  }
  void sort(Matrix& a) {
    for (Eigen::Index i = 0; i < a.rows(); ++i) {
      Eigen::Index largest = i;
      for (Eigen::Index j = i + 1; j < a.rows(); ++j)
        if (sizes_(j) > sizes_(largest)) largest = j;
      if (largest == i) continue;
      std::swap(sizes_(i), sizes_(largest));
      a.row(i).swap(a.row(largest));
      u_.col(i).swap(u_.col(largest));
    }
  }

  Eigen::Matrix<number, rows, rows> u_;
  Eigen::Matrix<number, columns, columns> v_;
  left sizes_;
};

} // namespace kanexpr::numeric
