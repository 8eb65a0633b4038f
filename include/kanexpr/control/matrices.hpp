#pragma once

#include <kanexpr/compiled/status.hpp>
#include <kanexpr/numeric/as_eigen.hpp>

#include <concepts>
#include <type_traits>

/// Functions of this room take matrices of Eigen while the program runs and `numeric::fixed_matrix` in a
/// constant expression, and give what they take.
namespace kanexpr::control {

using numeric::fixed_matrix;

/// The type and size of a matrix; a size that only the program knows is negative.
template <class Matrix>
struct shape {
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

/// Whether A and B fit; where they do not, the end of the compilation.
template <class A, class B>
constexpr bool are_fitting() {
  constexpr bool are_known =
      shape<A>::rows >= 0 && shape<A>::columns >= 0 && shape<B>::rows >= 0 && shape<B>::columns >= 0;
  constexpr bool is_square = shape<A>::rows == shape<A>::columns,
                 are_alike = shape<A>::rows == shape<B>::rows;
  constexpr bool are_numbers_alike = std::is_same_v<typename shape<A>::scalar, typename shape<B>::scalar>;
  static_assert(are_known, "the size of a matrix must be known to the compiler");
  static_assert(!are_known || is_square, "the state matrix A is not square");
  static_assert(!are_known || are_alike, "A and B have different numbers of rows");
  static_assert(!are_known || are_numbers_alike, "the numbers of A and B are of different types");
  return are_known && is_square && are_alike && are_numbers_alike;
}

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

/// a + part (b − a); of fixed matrices without others between.
template <class T, class Given>
constexpr Given between(const Given& a, const Given& b, T part) {
  return Given(a + part * (b - a));
}
template <class T, int rows, int columns>
constexpr fixed_matrix<T, rows, columns> between(const fixed_matrix<T, rows, columns>& a,
                                                 const fixed_matrix<T, rows, columns>& b, T part) {
  fixed_matrix<T, rows, columns> m;
  for (int i = 0; i < rows * columns; ++i) m.entries[i] = a.entries[i] + part * (b.entries[i] - a.entries[i]);
  return m;
}

/// Whether a gain can be used.
template <class T, int rows, int columns>
constexpr bool is_finite_gain(const fixed_matrix<T, rows, columns>& gain) {
  return numeric::is_finite(gain);
}
template <class Derived>
bool is_finite_gain(const Eigen::MatrixBase<Derived>& gain) {
  return numeric::is_finite(numeric::as_fixed(gain));
}
template <std::floating_point T>
constexpr bool is_finite_gain(T gain) {
  return numeric::is_finite(fixed_matrix<T, 1, 1>{{gain}});
}

/// The first of the statuses of results that says that there is none.
template <class... Result>
constexpr status first_failure(const Result&... results) {
  status first;
  ((first = first ? compiled::status_of(results) : first), ...);
  return first;
}

template <class T, int rows, int columns>
constexpr fixed_matrix<T, rows, columns> no_numbers() {
  fixed_matrix<T, rows, columns> none;
  for (T& entry : none.entries) entry = numeric::not_a_number<T>;
  return none;
}

} // namespace kanexpr::control
