#pragma once

#include <kanexpr/numeric/fixed_matrix.hpp>

#include <Eigen/Core>

namespace kanexpr::numeric {

/// Converts a `fixed_matrix` to an Eigen matrix: `-as_eigen(K) * x`.
template <class Number, int rows, int columns>
Eigen::Matrix<Number, rows, columns> as_eigen(const fixed_matrix<Number, rows, columns>& m) {
  Eigen::Matrix<Number, rows, columns> same;
  for (int i = 0; i < rows * columns; ++i) same.data()[i] = m.entries[i];
  return same;
}

/// Returns an Eigen matrix unchanged.
template <class Derived>
const Derived& as_eigen(const Eigen::MatrixBase<Derived>& m) {
  return m.derived();
}

template <class Matrix>
inline constexpr bool has_fixed_size =
    Matrix::RowsAtCompileTime != Eigen::Dynamic && Matrix::ColsAtCompileTime != Eigen::Dynamic;

/// Converts a fixed-size Eigen expression to a `fixed_matrix`.
template <class Derived>
auto as_fixed(const Eigen::MatrixBase<Derived>& m) {
  static_assert(has_fixed_size<Derived>, "the size of a matrix must be known at compile time");
  constexpr int rows = Derived::RowsAtCompileTime, columns = Derived::ColsAtCompileTime;
  const Eigen::Matrix<typename Derived::Scalar, rows, columns> evaluated = m;
  fixed_matrix<typename Derived::Scalar, rows, columns> same;
  for (int j = 0; j < columns; ++j)
    for (int i = 0; i < rows; ++i) same(i, j) = evaluated(i, j);
  return same;
}

} // namespace kanexpr::numeric
