// builds: clang++ sanitize
#include "evaluate_graph.hpp"

#include <kanexpr/symbolic/cost.hpp>
#include <kanexpr/symbolic/linear/solve.hpp>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

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
    kanexpr::base::name called("s");
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
      const Eigen::VectorXd x = s.value_of(solve_symmetric(s.g, s.entries(), s.right()).x);
      const Eigen::VectorXd expected = a.ldlt().solve(b);
      EXPECT_LE((x - expected).norm(), 1e-13 * (1 + expected.norm()) * a.norm()) << n << ' ' << density;
    }
}

TEST(solve_symmetric, costs_no_more_than_the_structure_asks_for) {
  constexpr int n = 8;
  const auto cost_for = [](const Eigen::MatrixXd& a) {
    linear_system s(a, Eigen::VectorXd::Ones(n), true);
    sequence<int> outputs;
    for (const expression e : solve_symmetric(s.g, s.entries(), s.right()).x) outputs.push(e.node());
    return cost_of(s.g, outputs);
  };
  Eigen::MatrixXd diagonal = Eigen::MatrixXd::Identity(n, n), arrow = diagonal, chain = diagonal;
  for (int i = 1; i < n; ++i) {
    arrow(0, i) = arrow(i, 0) = 0.1;
    chain(i, i - 1) = chain(i - 1, i) = 0.1;
  }
  EXPECT_EQ(cost_for(diagonal).divisions, n);
  EXPECT_EQ(cost_for(diagonal).additions, 0);
  // in each of n-1 eliminations: one entry of M and one of f, and one of x during back substitution
  EXPECT_EQ(cost_for(arrow).additions, 3 * (n - 1));
  EXPECT_EQ(cost_for(chain).additions, 3 * (n - 1));
  EXPECT_EQ(cost_for(arrow).divisions, n);
}

/// A base of two unknowns with three branches of three unknowns each, whose right-hand sides are zero except
/// in one branch, in one unknown, or everywhere.
TEST(solve_symmetric, prepares_for_columns_that_are_zero_in_whole_branches) {
  constexpr int base = 2, length = 3, n = base + 3 * length;
  std::mt19937 engine(8);
  Eigen::MatrixXd root = random_matrix(engine, n, 1);
  for (int i = base; i < n; ++i)
    for (int j = base; j < n; ++j)
      if ((i - base) / length != (j - base) / length) root(i, j) = 0;
  root.topRightCorner(base, n - base).setZero();
  const Eigen::MatrixXd a = root.transpose() * root + Eigen::MatrixXd::Identity(n, n);
  const Eigen::VectorXd b = random_matrix(engine, n, 1).col(0);
  const auto solved = [&](bool is_prepared, int& operations) {
    linear_system s(a, b, true);
    symmetric_factorization m(s.g, s.entries());
    matrix right(s.g, n, 3 * length + 4);
    for (int j = 0; j < right.columns; ++j)
      for (int i = 0; i < n; ++i) {
        const bool is_within = i < base || (i - base) / length == j / length || j == 3 * length;
        if (j <= 3 * length ? is_within : i == 3 * j - 28) right(i, j) = s.right()[i];
      }
    if (is_prepared) m.prepare_for(right);
    Eigen::MatrixXd x(n, right.columns);
    sequence<int> outputs;
    for (int j = 0; j < right.columns; ++j) {
      sequence<expression> column;
      for (int i = 0; i < n; ++i) column.push(right(i, j) * constant(s.g, exactly(j + 1)));
      const sequence<expression> found = m.solve(column).x;
      x.col(j) = s.value_of(found);
      for (const expression e : found) outputs.push(e.node());
      const Eigen::VectorXd expected = a.ldlt().solve(s.value_of(column));
      EXPECT_LE((x.col(j) - expected).norm(), 1e-13 * (1 + expected.norm()) * a.norm()) << j;
    }
    const cost c = cost_of(s.g, outputs);
    operations = c.multiplications + c.additions;
    return x;
  };
  int prepared = 0, unprepared = 0;
  const Eigen::MatrixXd x = solved(true, prepared), y = solved(false, unprepared);
  EXPECT_LE((x - y).norm(), 1e-13 * x.norm() * a.norm());
  EXPECT_LT(prepared, unprepared - 50);
}

Eigen::VectorXd column_of(const linear_system& s, const matrix& x, int column) {
  sequence<expression> entries;
  for (int i = 0; i < x.rows; ++i) entries.push(x(i, column));
  return s.value_of(entries);
}

matrix column(graph& g, const sequence<expression>& entries) {
  matrix m(g, entries.size(), 1);
  m.entries = entries;
  return m;
}

/// Rows and columns in an order that hides a block triangular form.
Eigen::MatrixXd shuffled(std::mt19937& engine, const Eigen::MatrixXd& a) {
  std::vector<Eigen::Index> rows(static_cast<std::size_t>(a.rows())), columns(rows);
  std::iota(rows.begin(), rows.end(), 0);
  std::iota(columns.begin(), columns.end(), 0);
  std::ranges::shuffle(rows, engine);
  std::ranges::shuffle(columns, engine);
  return a(rows, columns);
}

TEST(solve_linear, agrees_with_lu_for_any_sparsity) {
  std::mt19937 engine(6);
  int singular = 0;
  for (int n = 1; n <= 8; ++n)
    for (int repeat = 0; repeat < 12; ++repeat)
      for (const double density : {0.2, 0.4, 0.7, 1.0}) {
        Eigen::MatrixXd a = random_matrix(engine, n, density);
        a.diagonal().setZero(); // no pivots on the diagonal
        for (int i = 0; i < n; ++i) a(i, (i + 1) % n) += 2;
        a = shuffled(engine, a);
        const Eigen::VectorXd b = random_matrix(engine, n, 0.8).col(0);
        linear_system s(a, b, false);
        const linear_solution solved = solve_linear(s.g, s.entries(), column(s.g, s.right()));
        EXPECT_TRUE(solved.structurally_regular);
        const Eigen::FullPivLU<Eigen::MatrixXd> lu(a);
        if (lu.rcond() < 1e-4) {
          ++singular;
          continue;
        }
        const Eigen::VectorXd expected = lu.solve(b);
        EXPECT_LE((column_of(s, solved.x, 0) - expected).norm(), 1e-12 * (1 + expected.norm()))
            << n << ' ' << density;
        for (const solved_block& block : solved.blocks) {
          EXPECT_EQ(block.rows.size(), block.columns.size());
          const double measure = std::abs(s.value_of({block.measure})(0)),
                       scale = s.value_of({block.scale})(0);
          EXPECT_GT(measure, 1e-9 * scale);
          EXPECT_LE(measure, std::sqrt(6) * (1 + 1e-15) * scale); // six products in a determinant
        }
      }
  EXPECT_LT(singular, 100);
}

TEST(solve_linear, finds_the_blocks) {
  std::mt19937 engine(7);
  for (int repeat = 0; repeat < 30; ++repeat) {
    const int sizes[]{1, 3, 1, 2, 1};
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(8, 8);
    for (int block = 0, at = 0; block < 5; at += sizes[block++]) {
      const int n = sizes[block];
      a.block(at, at, n, n).setRandom();
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < at; ++j)
          if (engine() % 3 == 0) a(at + i, j) = 0.5;
    }
    a = shuffled(engine, a);
    const Eigen::VectorXd b = Eigen::VectorXd::Random(8);
    linear_system s(a, b, false);
    const linear_solution solved = solve_linear(s.g, s.entries(), column(s.g, s.right()));
    std::vector<int> found;
    for (const solved_block& block : solved.blocks) found.push_back(block.rows.size());
    std::ranges::sort(found);
    EXPECT_EQ(found, (std::vector<int>{1, 1, 1, 2, 3}));
    const Eigen::VectorXd expected = a.fullPivLu().solve(b);
    EXPECT_LE((column_of(s, solved.x, 0) - expected).norm(), 1e-12 * expected.norm() / a.fullPivLu().rcond());
  }
}

TEST(solve_linear, divides_where_one_unknown_is_left) {
  graph g;
  const auto symbol = [&g](const char* called) {
    return variable(g, {symbol_kind::parameter, kanexpr::base::name(called), 0});
  };
  const expression a = symbol("a"), b = symbol("b"), c = symbol("c");
  matrix m(g, 3, 3), one(g, 3, 1), two(g, 3, 2);
  m(0, 2) = constant(g, exactly(2));
  m(1, 0) = a, m(1, 2) = b;
  m(2, 0) = c, m(2, 1) = -b;
  for (int i = 0; i < 3; ++i) one(i, 0) = two(i, 0) = symbol("x"), two(i, 1) = symbol("y");
  const linear_solution single = solve_linear(g, m, one);
  EXPECT_EQ(single.x(2, 0), symbol("x") / 2);
  EXPECT_EQ(single.x(0, 0), (symbol("x") - b * (symbol("x") / 2)) / a);
  ASSERT_EQ(single.blocks.size(), 2); // a division by a number is always regular
  EXPECT_EQ(single.blocks[0].key, a.node());
  EXPECT_EQ(single.blocks[1].key, b.node());
  const linear_solution both = solve_linear(g, m, two);
  sequence<int> outputs = nodes_of(both.x.entries);
  EXPECT_EQ(cost_of(g, outputs).divisions, 2);

  const auto live = live_nodes(g, {single.x(0, 0).node()});
  EXPECT_TRUE(depends_on_block(g, live, a.node()));
  EXPECT_FALSE(depends_on_block(g, live, b.node())); // it is needed, but not as a divisor
}

TEST(solve_linear, tells_a_structurally_singular_matrix_and_solves_the_rest) {
  Eigen::Matrix4d a;
  a << 2, 0, 0, 0, //
      1, 0, 0, 3,  //
      1, 0, 0, 1,  //
      1, 1, 1, 1;
  linear_system s(a, Eigen::Vector4d(4, 8, 3, 1), false);
  const linear_solution solved = solve_linear(s.g, s.entries(), column(s.g, s.right()));
  EXPECT_FALSE(solved.structurally_regular);
  EXPECT_TRUE(column_of(s, solved.x, 0).isApprox(Eigen::Vector4d(2, 0, 0, 2)));
}

// One equation with the coefficients a and b, derived from a sum and solved for the unknown of a.
solved_block only_block(graph& g, const expression& a, const expression& b, const expression& sum) {
  matrix unknown(g, 1, 1), right(g, 1, 1), both(g, 1, 2);
  unknown(0, 0) = both(0, 0) = a;
  both(0, 1) = b;
  right(0, 0) = constant(g, exactly(1));
  const linear_solution solved = solve_linear(g, unknown, right, both, {sum.node()});
  EXPECT_EQ(solved.blocks.size(), 1);
  return solved.blocks[0];
}

TEST(solve_linear, measures_alike_in_all_units) {
  std::mt19937 engine(8);
  std::uniform_int_distribution<int> decade(-12, 12);
  int regular = 0;
  for (int n = 1; n <= 7; ++n)
    for (int repeat = 0; repeat < 60; ++repeat) {
      const double density = repeat % 3 == 0 ? 1 : 0.6;
      Eigen::MatrixXd a = random_matrix(engine, n, density);
      for (int i = 0; i < n; ++i) a(i, (i + repeat) % n) += 1;
      Eigen::MatrixXd singular = a;
      singular.row(n - 1) = singular.topRows(n - 1).colwise().sum();
      const auto factor = [&](Eigen::Index) { return std::pow(10.0, decade(engine)); };
      const Eigen::VectorXd rows = Eigen::VectorXd::NullaryExpr(n, factor);
      const Eigen::VectorXd columns = Eigen::VectorXd::NullaryExpr(n, factor);
      const auto beside_scale = [&](const Eigen::MatrixXd& m) {
        linear_system s(rows.asDiagonal() * m * columns.asDiagonal(), Eigen::VectorXd::Ones(n), false);
        const linear_solution solved = solve_linear(s.g, s.entries(), column(s.g, s.right()));
        double least = solved.structurally_regular ? 1 : 0;
        for (const solved_block& each : solved.blocks)
          least = std::min(least, std::abs(s.value_of({each.measure})(0)) / s.value_of({each.scale})(0));
        if (density == 1 && n > 1) {
          EXPECT_EQ(solved.blocks.size(), 1);
        }
        return least;
      };
      if (n > 1) {
        EXPECT_LT(beside_scale(singular), 1e-13) << n;
      }
      if (a.fullPivLu().rcond() < 0.02) continue;
      ++regular;
      EXPECT_GT(beside_scale(a), 1e-5) << n;
    }
  EXPECT_GT(regular, 150);
}

TEST(solve_linear, measures_by_what_does_not_vanish_with_the_equation) {
  graph g;
  const expression angle = variable(g, {symbol_kind::coordinate, "q", 0});
  const expression x = variable(g, {symbol_kind::coordinate, "x", 1});
  const expression y = variable(g, {symbol_kind::coordinate, "y", 2});
  const expression l = variable(g, {symbol_kind::parameter, "l", 0});
  const std::vector<double> at{1.2, 0.3, 0.4, 2};
  const auto scale = [&](const expression& a, const expression& b, const expression& sum) {
    const solved_block found = only_block(g, a, b, sum);
    EXPECT_EQ(found.key, a.node());
    return evaluate(found.scale, at);
  };
  const double both = std::sqrt((0.3 * 0.3 + 0.4 * 0.4) / 2);
  EXPECT_DOUBLE_EQ(scale(l * cos(angle), l, l), std::sqrt(2)); // of all angles
  EXPECT_DOUBLE_EQ(scale(l * cos(angle) - l * sin(angle), l, l), 2);
  EXPECT_DOUBLE_EQ(scale(x, y, x * x + y * y - l * l), both); // of all coordinates that are lengths
  EXPECT_DOUBLE_EQ(scale(x, y, l), 0.3);                      // the unit of y is unknown
  EXPECT_DOUBLE_EQ(scale(x, angle, x + l * angle), 0.3);      // an angle is not a length
  EXPECT_DOUBLE_EQ(scale(x + y, y, l), 0.5);                  // the coefficients are sums too
  EXPECT_DOUBLE_EQ(scale(l * x, y / l, x - y), 2 * both);
  EXPECT_DOUBLE_EQ(scale(x / l, y, x - y), both / 2); // divisors contribute their values
  EXPECT_DOUBLE_EQ(evaluate(only_block(g, l * cos(angle), l, l).measure, at), 2 * std::cos(1.2));
}

} // namespace
