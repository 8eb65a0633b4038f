// builds: clang++ sanitize
// Minimum-norm least-squares solutions for matrices of any shape and rank, compared with the singular value
// decomposition.
#include <kanexpr/numeric/complete_orthogonal.hpp>

#include <Eigen/SVD>
#include <gtest/gtest.h>

#include <random>

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using kanexpr::numeric::complete_orthogonal;

MatrixXd random_matrix(Eigen::Index rows, Eigen::Index columns, std::mt19937& dice) {
  std::uniform_real_distribution<double> side(-1, 1);
  return MatrixXd::NullaryExpr(rows, columns, [&] { return side(dice); });
}

TEST(complete_orthogonal, gives_the_least_solution) {
  std::mt19937 dice(5);
  for (const auto& [rows, columns, rank] : {std::array<Eigen::Index, 3>{4, 4, 4},
                                            {7, 4, 4},
                                            {4, 7, 4},
                                            {6, 6, 3},
                                            {9, 5, 2},
                                            {5, 9, 3},
                                            {1, 3, 1},
                                            {3, 1, 1}})
    for (int i = 0; i < 20; ++i) {
      const MatrixXd a = random_matrix(rows, rank, dice) * random_matrix(rank, columns, dice);
      const VectorXd b = random_matrix(rows, 1, dice);
      const complete_orthogonal factors(a, 1e-12 * a.norm());
      ASSERT_EQ(factors.rank(), rank);
      Eigen::JacobiSVD<MatrixXd> reference(a, Eigen::ComputeThinU | Eigen::ComputeThinV);
      reference.setThreshold(1e-12);
      const double condition = reference.singularValues()(0) / reference.singularValues()(rank - 1);
      const VectorXd wanted = reference.solve(b);
      EXPECT_LE((factors.solve(b) - wanted).norm(), 1e-14 * condition * condition * wanted.norm());
      const MatrixXd& q = factors.range();
      EXPECT_LE((q.transpose() * q - MatrixXd::Identity(rank, rank)).norm(), 1e-14);
      EXPECT_LE((a - q * (q.transpose() * a)).norm(), 1e-14 * a.norm());
    }
}

TEST(complete_orthogonal, stays_orthogonal_where_columns_are_nearly_parallel) {
  MatrixXd a = MatrixXd::Ones(5, 4);
  for (Eigen::Index i = 0; i < 4; ++i) a(i, i) += 1e-7;
  const MatrixXd q = kanexpr::numeric::orthonormal_columns(a, 0);
  EXPECT_LE((q.transpose() * q - MatrixXd::Identity(4, 4)).norm(), 1e-14);
}

TEST(complete_orthogonal, of_nothing_gives_nothing) {
  const VectorXd b = VectorXd::Ones(3);
  EXPECT_EQ(complete_orthogonal(MatrixXd::Zero(3, 2), 0).solve(b), VectorXd::Zero(2));
  EXPECT_EQ(complete_orthogonal(MatrixXd(3, 0), 0).solve(b).size(), 0);
  EXPECT_EQ(complete_orthogonal(MatrixXd(0, 2), 0).solve(VectorXd()), VectorXd::Zero(2));
}

} // namespace
