#pragma once

#include <kanexpr/numeric/singular_values.hpp>

#include <Eigen/Core>
#include <limits>
#include <utility>

namespace kanexpr::numeric {

/// Minimizes ½ xᵀ M x − gᵀ x subject to J x = b for a J of any rank; if rows are linearly dependent, the
/// combinations of rows with the smallest singular values are discarded. M is symmetric, and positive
/// definite on the null space of J. With g = M x₀, the solution is the x nearest to x₀ in the metric M; this
/// is the form in which Gauss's principle determines accelerations.
template <class Mass, class Jacobian>
class constrained_minimum {
  using number = typename Mass::Scalar;
  using unknowns = Eigen::Matrix<number, Mass::RowsAtCompileTime, 1>;
  using equations = Eigen::Matrix<number, Jacobian::RowsAtCompileTime, 1>;

public:
  constrained_minimum(const Mass& mass, singular_values<Jacobian> of, Eigen::Index rank)
      : mass_(mass), of_(std::move(of)), rank_(rank), factors_(Mass::Zero(mass.rows(), mass.rows())) {
    of_.complete_basis(rank_);
    factorize();
  }

  /// Whether M is positive definite on the null space of J.
  bool is_regular() const { return is_regular_; }

  unknowns solve(const unknowns& g, const equations& b) const {
    unknowns x = unknowns::Zero(g.size());
    for (Eigen::Index i = 0; i < rank_; ++i) x += (of_.left_vector(i).dot(b) / of_[i]) * of_.right_vector(i);
    const unknowns force = g - mass_.lazyProduct(x);
    unknowns z = unknowns::Zero(g.size());
    for (Eigen::Index i = 0; i < free(); ++i) z(i) = direction(i).dot(force);
    for (Eigen::Index i = 0; i < free(); ++i) {
      for (Eigen::Index j = 0; j < i; ++j) z(i) -= factors_(i, j) * z(j);
      z(i) /= factors_(i, i);
    }
    for (Eigen::Index i = free(); i-- > 0;) {
      for (Eigen::Index j = i + 1; j < free(); ++j) z(i) -= factors_(j, i) * z(j);
      z(i) /= factors_(i, i);
    }
    for (Eigen::Index i = 0; i < free(); ++i) x += z(i) * direction(i);
    return x;
  }

  /// Returns the minimum-norm λ with Jᵀ λ = M x − g.
  equations multipliers(const unknowns& g, const unknowns& x) const {
    const unknowns force = mass_.lazyProduct(x) - g;
    equations found = equations::Zero(of_.left_vector(0).size());
    for (Eigen::Index i = 0; i < rank_; ++i)
      found += (of_.right_vector(i).dot(force) / of_[i]) * of_.left_vector(i);
    return found;
  }

private:
  Eigen::Index free() const { return mass_.rows() - rank_; }
  auto direction(Eigen::Index i) const { return of_.right_vector(rank_ + i); }

  /// Computes the Cholesky factors of M restricted to the free directions.
  void factorize() {
    for (Eigen::Index i = 0; i < free(); ++i)
      for (Eigen::Index j = 0; j <= i; ++j) {
        const unknowns moved = mass_.lazyProduct(direction(j));
        const number entry = direction(i).dot(moved);
        number left = entry;
        for (Eigen::Index k = 0; k < j; ++k) left -= factors_(i, k) * factors_(j, k);
        if (i != j) {
          factors_(i, j) = left / factors_(j, j);
          continue;
        }
        is_regular_ = is_regular_ && left > 64 * std::numeric_limits<number>::epsilon() * entry;
        factors_(i, i) = std::sqrt(left);
      }
  }

  const Mass& mass_;
  singular_values<Jacobian> of_;
  Eigen::Index rank_;
  Mass factors_;
  bool is_regular_ = true;
};

} // namespace kanexpr::numeric
