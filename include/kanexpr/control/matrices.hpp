#pragma once

#include <kanexpr/numeric/as_eigen.hpp>

/// Functions of this room take matrices of Eigen while the program runs and `numeric::fixed_matrix` in a
/// constant expression, and give what they take.
namespace kanexpr::control {

using numeric::fixed_matrix;

/// The type and size of a matrix.
template <class Matrix>
struct shape {
  static_assert(numeric::has_fixed_size<Matrix>, "the size of a matrix must be known to the compiler");
  using scalar = typename Matrix::Scalar;
  static constexpr int rows = Matrix::RowsAtCompileTime, columns = Matrix::ColsAtCompileTime;

  template <class T, int r, int c>
  static auto like(const fixed_matrix<T, r, c>& m) {
    return numeric::as_eigen(m);
  }
};
template <class T, int r, int c>
struct shape<fixed_matrix<T, r, c>> {
  using scalar = T;
  static constexpr int rows = r, columns = c;

  template <int other_rows, int other_columns>
  static constexpr const auto& like(const fixed_matrix<T, other_rows, other_columns>& m) {
    return m;
  }
};

template <class M>
inline constexpr bool is_fixed_matrix = false;
template <class T, int rows, int columns>
inline constexpr bool is_fixed_matrix<fixed_matrix<T, rows, columns>> = true;

/// Of Eigen or fixed.
template <class M>
concept matrix = is_fixed_matrix<M> || requires { M::RowsAtCompileTime; };

template <class Derived>
auto fixed(const Eigen::MatrixBase<Derived>& m) {
  return numeric::as_fixed(m);
}
template <class T, int rows, int columns>
constexpr const fixed_matrix<T, rows, columns>& fixed(const fixed_matrix<T, rows, columns>& m) {
  return m;
}

template <class T, int rows, int columns>
constexpr fixed_matrix<T, rows, columns> no_numbers() {
  fixed_matrix<T, rows, columns> none;
  for (T& entry : none.entries) entry = std::numeric_limits<T>::quiet_NaN();
  return none;
}

} // namespace kanexpr::control
