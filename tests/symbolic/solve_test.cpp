// builds: sanitize
#include "evaluate_graph.hpp"

#include <kanexpr/symbolic/solve.hpp>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include <random>

namespace {

using namespace kanexpr::symbolic;
using graph_evaluation::evaluate;

/// A system A x = b whose entries are symbols, zero where A is.
class linear_system {
public:
  linear_system(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, bool is_symmetric)
      : matrix_(g, static_cast<int>(a.rows()), static_cast<int>(a.cols())) {
    for (int i = 0; i < matrix_.rows; ++i)
      for (int j = 0; j < matrix_.columns; ++j)
        if (a(i, j) != 0) matrix_(i, j) = is_symmetric && j > i ? wrong() : next(a(i, j));
    for (int i = 0; i < matrix_.rows; ++i) right_.push(b(i) == 0 ? constant(g, exactly(0)) : next(b(i)));
  }

  const matrix& entries() const { return matrix_; }
  const sequence<expression>& right() const { return right_; }

  Eigen::VectorXd value_of(const sequence<expression>& x) const {
    Eigen::VectorXd value(x.size());
    for (int i = 0; i < x.size(); ++i) value(i) = evaluate(x[i], values_);
    return value;
  }

  graph g;

private:
  expression next(double value) {
    name called("s");
    called.append(static_cast<int>(values_.size()));
    values_.push_back(value);
    return variable(g, {symbol_kind::parameter, called, 0});
  }
  expression wrong() { return next(std::nan("")); } // must not be read

  std::vector<double> values_;
  matrix matrix_;
  sequence<expression> right_;
};

Eigen::MatrixXd random_matrix(std::mt19937& engine, int n, double density) {
  std::uniform_real_distribution<double> entry(-1, 1), chance(0, 1);
  return Eigen::MatrixXd::NullaryExpr(n, n, [&] { return chance(engine) < density ? entry(engine) : 0.0; });
}

TEST(solve_symmetric, agrees_with_ldlt_for_any_sparsity) {
  std::mt19937 engine(5);
  for (int n = 1; n <= 9; ++n)
    for (const double density : {0.0, 0.1, 0.2, 0.4, 1.0}) {
      const Eigen::MatrixXd root = random_matrix(engine, n, density);
      const Eigen::MatrixXd a = root * root.transpose() + Eigen::MatrixXd::Identity(n, n);
      const Eigen::VectorXd b = random_matrix(engine, n, 0.7).col(0);
      linear_system s(a, b, true);
      const Eigen::VectorXd x = s.value_of(solve_symmetric(s.g, s.entries(), s.right()));
      const Eigen::VectorXd expected = a.ldlt().solve(b);
      EXPECT_LE((x - expected).norm(), 1e-13 * (1 + expected.norm()) * a.norm()) << n << ' ' << density;
    }
}

TEST(solve_symmetric, costs_no_more_than_the_structure_asks_for) {
  constexpr int n = 8;
  const auto cost_for = [](const Eigen::MatrixXd& a) {
    linear_system s(a, Eigen::VectorXd::Ones(n), true);
    sequence<int> outputs;
    for (const expression e : solve_symmetric(s.g, s.entries(), s.right())) outputs.push(e.node());
    return cost_of(s.g, outputs);
  };
  Eigen::MatrixXd diagonal = Eigen::MatrixXd::Identity(n, n), arrow = diagonal, chain = diagonal;
  for (int i = 1; i < n; ++i) {
    arrow(0, i) = arrow(i, 0) = 0.1;
    chain(i, i - 1) = chain(i - 1, i) = 0.1;
  }
  EXPECT_EQ(cost_for(diagonal).divisions, n);
  EXPECT_EQ(cost_for(diagonal).additions, 0);
  // each of n-1 eliminations: one entry of M and one of f, and one of x on the way back
  EXPECT_EQ(cost_for(arrow).additions, 3 * (n - 1));
  EXPECT_EQ(cost_for(chain).additions, 3 * (n - 1));
  EXPECT_EQ(cost_for(arrow).divisions, n);
}

TEST(solve_by_cofactors, agrees_with_lu) {
  std::mt19937 engine(6);
  for (int n = 1; n <= 6; ++n)
    for (const double density : {0.3, 0.6, 1.0}) {
      Eigen::MatrixXd a = random_matrix(engine, n, density);
      a.rowwise() += 2 * Eigen::RowVectorXd::Unit(n, n / 2); // no diagonal to pivot on
      for (int i = 0; i < n; ++i) a(i, (i + 1) % n) += 3;
      const Eigen::VectorXd b = random_matrix(engine, n, 0.8).col(0);
      linear_system s(a, b, false);
      const Eigen::PartialPivLU<Eigen::MatrixXd> lu(a);
      const Eigen::VectorXd x = s.value_of(solve_by_cofactors(s.g, s.entries(), s.right()));
      const Eigen::VectorXd expected = lu.solve(b);
      EXPECT_LE((x - expected).norm(), 1e-12 * (1 + expected.norm())) << n << ' ' << density;
      const double determinant = s.value_of({kanexpr::symbolic::determinant(s.g, s.entries())})(0);
      EXPECT_NEAR(determinant, lu.determinant(), 1e-12 * (1 + std::abs(determinant)));
    }
}

TEST(solve_by_cofactors, needs_no_pivot) {
  Eigen::MatrixXd a(3, 3);
  a << 0, 2, 0, 0, 0, 3, 4, 0, 0;
  linear_system s(a, Eigen::Vector3d(2, 6, 12), false);
  EXPECT_TRUE(s.value_of(solve_by_cofactors(s.g, s.entries(), s.right())).isApprox(Eigen::Vector3d(3, 1, 2)));
}

} // namespace
