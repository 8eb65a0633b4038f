#pragma once

#include <kanexpr/numeric/factorized.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <optional>

namespace kanexpr::numeric {

/// Returns orthonormal columns that span the column space of `a`, computed by the Gram-Schmidt process with
/// column pivoting and reorthogonalization (Golub & Van Loan, Matrix Computations, section 5.2). Remainders
/// of length `least` or below are treated as zero.
inline Eigen::MatrixXd orthonormal_columns(Eigen::MatrixXd a, double least) {
  Eigen::MatrixXd q(a.rows(), (std::min)(a.rows(), a.cols()));
  Eigen::Index rank = 0;
  for (; rank < q.cols(); ++rank) {
    Eigen::Index longest = 0;
    for (Eigen::Index j = 1; j < a.cols(); ++j)
      if (a.col(j).norm() > a.col(longest).norm()) longest = j;
    const double length = a.col(longest).norm();
    if (!(length > least)) break;
    auto next = q.col(rank);
    next = a.col(longest) / length;
    for (Eigen::Index i = 0; i < rank; ++i) next -= q.col(i).dot(next) * q.col(i);
    next /= next.norm();
    for (Eigen::Index j = 0; j < a.cols(); ++j) a.col(j) -= next.dot(a.col(j)) * next;
  }
  return q.leftCols(rank);
}

/// The decomposition A = Q C Vᵀ of any matrix, with orthonormal columns of Q and V and a regular square C. It
/// gives the minimum-norm least-squares solution of A x = b.
class complete_orthogonal {
public:
  complete_orthogonal(const Eigen::MatrixXd& a, double least) : q_(orthonormal_columns(a, least)) {
    const Eigen::MatrixXd rows = q_.transpose().lazyProduct(a);
    v_ = orthonormal_columns(rows.transpose(), 0);
    if (rank() != 0) core_.emplace(rows.lazyProduct(v_).eval());
  }

  /// Returns orthonormal columns that span the column space of A.
  const Eigen::MatrixXd& range() const { return q_; }
  int rank() const { return static_cast<int>(q_.cols()); }

  Eigen::VectorXd solve(const Eigen::VectorXd& b) const {
    if (rank() == 0) return Eigen::VectorXd::Zero(v_.rows());
    Eigen::VectorXd y = q_.transpose().lazyProduct(b);
    core_->solve(y);
    return v_.lazyProduct(y);
  }

private:
  Eigen::MatrixXd q_, v_{};
  std::optional<factorized<Eigen::VectorXd>> core_{}; ///< factors of C; empty if A is zero
};

} // namespace kanexpr::numeric
