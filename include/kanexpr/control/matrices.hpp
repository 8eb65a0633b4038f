#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/compiled/status.hpp>
#include <kanexpr/numeric/as_eigen.hpp>

#include <Eigen/Core>
#include <type_traits>

/// The functions in this folder accept Eigen matrices at run time and `numeric::fixed_matrix` in constant
/// expressions; they return matrices of the same kind as their arguments.
namespace kanexpr::control {

using numeric::fixed_matrix;

/// The type and size of a matrix; a dynamic size is negative.
template <class Matrix>
struct shape {
  using scalar = typename Matrix::Scalar;
  static constexpr int rows = Matrix::RowsAtCompileTime, columns = Matrix::ColsAtCompileTime;

  template <class Number, int other_rows, int other_columns>
  static auto like(const fixed_matrix<Number, other_rows, other_columns>& m) {
    return numeric::as_eigen(m);
  }
};
template <class Number, int row_count, int column_count>
struct shape<fixed_matrix<Number, row_count, column_count>> {
  using scalar = Number;
  static constexpr int rows = row_count, columns = column_count;

  template <int other_rows, int other_columns>
  static constexpr const auto& like(const fixed_matrix<Number, other_rows, other_columns>& m) {
    return m;
  }
};

/// Whether A and B have matching sizes and scalar types; a static assertion fails if they do not.
template <class StateMatrix, class InputMatrix>
constexpr bool are_fitting() {
  constexpr bool are_known = shape<StateMatrix>::rows >= 0 && shape<StateMatrix>::columns >= 0 &&
                             shape<InputMatrix>::rows >= 0 && shape<InputMatrix>::columns >= 0;
  constexpr bool is_square = shape<StateMatrix>::rows == shape<StateMatrix>::columns,
                 are_alike = shape<StateMatrix>::rows == shape<InputMatrix>::rows;
  constexpr bool are_numbers_alike =
      std::is_same_v<typename shape<StateMatrix>::scalar, typename shape<InputMatrix>::scalar>;
  static_assert(are_known, "the size of a matrix must be known at compile time");
  static_assert(!are_known || is_square, "the state matrix A is not square");
  static_assert(!are_known || are_alike, "A and B have different numbers of rows");
  static_assert(!are_known || are_numbers_alike, "A and B have different scalar types");
  return are_known && is_square && are_alike && are_numbers_alike;
}

template <class Given>
inline constexpr bool is_fixed_matrix = false;
template <class Number, int rows, int columns>
inline constexpr bool is_fixed_matrix<fixed_matrix<Number, rows, columns>> = true;

/// An Eigen matrix or a `fixed_matrix`.
template <class Given>
concept matrix = is_fixed_matrix<Given> || requires { Given::RowsAtCompileTime; };

template <class Derived>
auto fixed(const Eigen::MatrixBase<Derived>& m) {
  return numeric::as_fixed(m);
}
template <class Number, int rows, int columns>
constexpr const fixed_matrix<Number, rows, columns>& fixed(const fixed_matrix<Number, rows, columns>& m) {
  return m;
}

/// Returns a + part (b − a); the overload for fixed matrices creates no temporary matrices.
template <class Number, class Given>
constexpr Given between(const Given& a, const Given& b, Number part) {
  return Given(a + part * (b - a));
}
template <class Number, int rows, int columns>
constexpr fixed_matrix<Number, rows, columns> between(const fixed_matrix<Number, rows, columns>& a,
                                                      const fixed_matrix<Number, rows, columns>& b,
                                                      Number part) {
  fixed_matrix<Number, rows, columns> m;
  for (int i = 0; i < rows * columns; ++i) m.entries[i] = a.entries[i] + part * (b.entries[i] - a.entries[i]);
  return m;
}

/// Whether a gain, a matrix or a number, is finite.
template <class Gain>
constexpr bool is_finite_gain(const Gain& gain) {
  if constexpr (matrix<Gain>)
    return numeric::is_finite(fixed(gain));
  else
    return numeric::is_finite(gain);
}

/// Returns the first status that reports a failure.
template <class... Result>
constexpr status first_failure(const Result&... results) {
  status first;
  ((first = first ? status_of(results) : first), ...);
  return first;
}

template <class Number, int rows, int columns>
constexpr fixed_matrix<Number, rows, columns> no_numbers() {
  fixed_matrix<Number, rows, columns> none;
  for (Number& entry : none.entries) entry = numeric::not_a_number<Number>;
  return none;
}

} // namespace kanexpr::control
