// Matrices for constant expressions: half of the test takes place during compilation.
// builds: sanitize
#include <kanexpr/numeric/as_eigen.hpp>

#include <Eigen/LU>

#include <gtest/gtest.h>

#include <limits>

namespace {

using namespace kanexpr::numeric;
namespace base = kanexpr::base;

constexpr auto a = by_rows({{1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}});
constexpr auto b = by_rows({{1.0, 0.0}, {2.0, -1.0}, {0.0, 3.0}});

static_assert(a(0, 2) == 3 && a(1, 0) == 4);
static_assert((a * b)(0, 0) == 5 && (a * b)(0, 1) == 7 && (a * b)(1, 0) == 14 && (a * b)(1, 1) == 13);
static_assert((a + transposed(b))(0, 1) == 4 && (a - transposed(b))(1, 2) == 3 && (2.0 * a)(1, 1) == 10);
static_assert(a.at({1}, {2, 0})(0, 0) == 6 && a.at({1}, {2, 0})(0, 1) == 4);
static_assert(a.cast<float>()(1, 2) == 6.0f);
static_assert(largest_entry(-1.0 * a) == 6 && identity<double, 3>()(2, 2) == 1 &&
              identity<double, 3>()(2, 1) == 0);
static_assert(symmetric(by_rows({{1.0, 2.0}, {4.0, 3.0}}))(1, 0) == 3);
static_assert(fixed_matrix<double, 1, 1>{{2.5}} == 2.5);

template <class T>
constexpr bool tells_what_is_finite() {
  fixed_matrix<T, 2, 2> m;
  bool all = is_finite(m);
  for (const T value : {std::numeric_limits<T>::infinity(), -std::numeric_limits<T>::infinity(),
                        std::numeric_limits<T>::quiet_NaN()}) {
    m(1, 0) = value;
    all = all && !is_finite(m);
  }
  m(1, 0) = std::numeric_limits<T>::max();
  return all && is_finite(m);
}
static_assert(tells_what_is_finite<float>() && tells_what_is_finite<double>());

// With a zero as the first pivot.
constexpr auto regular = by_rows({{0.0, 2.0, 1.0}, {1.0, 1.0, 0.0}, {3.0, 0.0, 1.0}});
constexpr eliminated<double, 3> factors(regular);
static_assert(!factors.is_singular());
static_assert(eliminated<double, 2>(by_rows({{1.0, 2.0}, {2.0, 4.0}})).is_singular());

TEST(fixed_matrix, solves_as_eigen_does) {
  constexpr auto x = factors.solve(b);
  const Eigen::Matrix<double, 3, 2> expected = as_eigen(regular).inverse() * as_eigen(b);
  EXPECT_LE((as_eigen(x) - expected).norm(), 1e-15);
}

// Columns are solved side by side, each with the operations of one alone, in constant expressions as well.
template <int columns>
constexpr bool are_solved_as_alone() {
  constexpr int order = 5;
  fixed_matrix<double, order, order> m;
  fixed_matrix<double, order, columns> right;
  unsigned seed = 1;
  const auto next = [&] { return double((seed = seed * 1664525U + 1013904223U) >> 8) * 1e-7 - 1; };
  for (double& entry : m.entries) entry = next();
  for (double& entry : right.entries) entry = next();
  const eliminated<double, order> of_m(m);
  const auto together = of_m.solve(right);
  bool all = true;
  for (int j = 0; j < columns; ++j) {
    const auto alone = of_m.solve(right.at({0, 1, 2, 3, 4}, {j}));
    for (int i = 0; i < order; ++i)
      all = all && base::equal(alone(i), together(i, j)) && !base::equal(alone(i), 0.0);
  }
  return all;
}
static_assert(are_solved_as_alone<1>() && are_solved_as_alone<9>());

constexpr auto definite = by_rows({{4e12, 1e6, 0.0}, {1e6, 2.0, 1e-6}, {0.0, 1e-6, 3e-12}});
constexpr positive_factors<double, 3> root(definite);
static_assert(root);
static_assert(!positive_factors<double, 2>(by_rows({{1.0, 1.0}, {1.0, 1.0}})));
static_assert(!positive_factors<double, 2>(by_rows({{1.0, 2.0}, {2.0, 1.0}})));
static_assert(!positive_factors<double, 2>(by_rows({{0.0, 0.0}, {0.0, 1.0}})));
static_assert(!positive_factors<double, 1>(by_rows({{-1.0}})));

// In units in which its entries span 24 powers of ten.
TEST(fixed_matrix, solves_with_positive_definite_matrices_in_any_units) {
  const Eigen::Vector3d units(1e-6, 1, 1e6);
  const Eigen::Matrix3d scaled = units.asDiagonal() * as_eigen(definite) * units.asDiagonal();
  const Eigen::Matrix<double, 3, 2> expected = scaled.inverse() * units.asDiagonal() * as_eigen(b);
  const Eigen::Matrix<double, 3, 2> found = units.cwiseInverse().asDiagonal() * as_eigen(root.solve(b));
  EXPECT_LE((found - expected).norm(), 1e-14 * expected.norm());
}

TEST(fixed_matrix, becomes_one_of_eigen_and_back) {
  const Eigen::Matrix<double, 2, 3> same = as_eigen(a);
  EXPECT_EQ(same, (Eigen::Matrix<double, 2, 3>{{1, 2, 3}, {4, 5, 6}}));
  const auto back = as_fixed(same.transpose());
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 2; ++j) EXPECT_EQ(back(i, j), a(j, i));
  const auto row = as_fixed(same.row(1) * 2);
  EXPECT_EQ(row(0, 2), 12);
}

} // namespace
