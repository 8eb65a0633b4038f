#pragma once

#include <kanexpr/numeric/elimination.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>

#include <cstddef>
#include <limits>
#include <type_traits>

namespace kanexpr::numeric {

/// A matrix for constant expressions, in which Eigen matrices cannot be used. `m(i, j)` is an entry; a 1-by-1
/// matrix converts to a number. The entries are stored in column-major order, as in Eigen.
template <class Number, int rows, int columns>
struct fixed_matrix {
  static constexpr std::size_t capacity = rows * columns > 0 ? static_cast<std::size_t>(rows* columns) : 1;
  Number entries[capacity]{};

  constexpr Number& operator()(int i, int j = 0) { return entries[i + j * rows]; }
  constexpr const Number& operator()(int i, int j = 0) const { return entries[i + j * rows]; }
  constexpr operator Number() const
    requires(rows == 1 && columns == 1)
  {
    return entries[0];
  }

  /// Returns the entries in the given rows and columns: `m.at({1, 2}, {0})`.
  template <std::size_t some_rows, std::size_t some_columns>
  constexpr fixed_matrix<Number, static_cast<int>(some_rows), static_cast<int>(some_columns)>
  at(const int (&in_rows)[some_rows], const int (&in_columns)[some_columns]) const {
    constexpr int height = static_cast<int>(some_rows), width = static_cast<int>(some_columns);
    fixed_matrix<Number, height, width> part;
    for (int j = 0; j < width; ++j)
      for (int i = 0; i < height; ++i) part(i, j) = (*this)(in_rows[i], in_columns[j]);
    return part;
  }

  /// Converts the matrix to a different scalar type: `K.cast<float>()`.
  template <class Other>
  constexpr fixed_matrix<Other, rows, columns> cast() const {
    fixed_matrix<Other, rows, columns> same;
    for (int i = 0; i < rows * columns; ++i) same.entries[i] = static_cast<Other>(entries[i]);
    return same;
  }

  friend constexpr fixed_matrix operator+(const fixed_matrix& a, const fixed_matrix& b) {
    fixed_matrix c;
    for (int i = 0; i < rows * columns; ++i) c.entries[i] = a.entries[i] + b.entries[i];
    return c;
  }
  friend constexpr fixed_matrix operator-(const fixed_matrix& a, const fixed_matrix& b) {
    fixed_matrix c;
    for (int i = 0; i < rows * columns; ++i) c.entries[i] = a.entries[i] - b.entries[i];
    return c;
  }
  friend constexpr fixed_matrix operator*(Number factor, const fixed_matrix& a) {
    fixed_matrix c;
    for (int i = 0; i < rows * columns; ++i) c.entries[i] = factor * a.entries[i];
    return c;
  }
};

template <class Number, int rows, int inner, int columns>
constexpr fixed_matrix<Number, rows, columns> operator*(const fixed_matrix<Number, rows, inner>& a,
                                                        const fixed_matrix<Number, inner, columns>& b) {
  fixed_matrix<Number, rows, columns> c;
  for (int j = 0; j < columns; ++j)
    for (int k = 0; k < inner; ++k) {
      const Number factor = b.entries[k + j * inner];
      for (int i = 0; i < rows; ++i) c.entries[i + j * rows] += a.entries[i + k * rows] * factor;
    }
  return c;
}

/// Returns a matrix written row by row, as in `by_rows({{1.0, 2.0}, {3.0, 4.0}})`.
template <class Number, std::size_t rows, std::size_t columns>
constexpr fixed_matrix<Number, static_cast<int>(rows), static_cast<int>(columns)>
by_rows(const Number (&written)[rows][columns]) {
  constexpr int height = static_cast<int>(rows), width = static_cast<int>(columns);
  fixed_matrix<Number, height, width> m;
  for (int i = 0; i < height; ++i)
    for (int j = 0; j < width; ++j) m(i, j) = written[i][j];
  return m;
}

template <class Number, int order>
constexpr fixed_matrix<Number, order, order> identity() {
  fixed_matrix<Number, order, order> one;
  for (int i = 0; i < order; ++i) one(i, i) = 1;
  return one;
}

/// Returns the transpose of a matrix, in constant expressions.
template <class Number, int rows, int columns>
constexpr fixed_matrix<Number, columns, rows> transposed(const fixed_matrix<Number, rows, columns>& m) {
  fixed_matrix<Number, columns, rows> t;
  for (int j = 0; j < columns; ++j)
    for (int i = 0; i < rows; ++i) t(j, i) = m(i, j);
  return t;
}

/// Returns (M + Mᵀ)/2 of a matrix that is symmetric up to rounding.
template <class Number, int order>
constexpr fixed_matrix<Number, order, order> symmetric(const fixed_matrix<Number, order, order>& m) {
  return Number(0.5) * (m + transposed(m));
}

/// Returns the largest magnitude of an entry, or NaN if an entry is NaN.
template <class Number, int rows, int columns>
constexpr Number largest_entry(const fixed_matrix<Number, rows, columns>& m) {
  Number most = 0;
  for (int i = 0; i < rows * columns; ++i) {
    const Number size = constant_elimination_math::magnitude(m.entries[i]);
    if (!(size <= most)) most = size;
    if (!base::is_number(most)) return most;
  }
  return most;
}

/// Whether all entries are finite. Tests their bits and therefore works with -ffast-math.
template <class Number, int rows, int columns>
constexpr bool is_finite(const fixed_matrix<Number, rows, columns>& m) {
  if (!std::is_constant_evaluated()) { // a sum may overflow here
    Number sum = 0;
    for (int i = 0; i < rows * columns; ++i) sum += m.entries[i];
    if (is_finite(sum)) return true;
  }
  for (int i = 0; i < rows * columns; ++i)
    if (!is_finite(m.entries[i])) return false;
  return true;
}

/// A constant expression must not overflow either, so a pivot small enough to cause overflow is treated as
/// zero, too.
struct bounded_elimination_math : constant_elimination_math {
  template <class Number>
  static constexpr Number least_pivot = power_of_two<Number>(-std::numeric_limits<Number>::max_exponent / 4);
  template <class Number>
  static constexpr Number reciprocal(Number x) {
    return magnitude(x) > least_pivot<Number> ? 1 / x : Number(0);
  }
};

/// A matrix that is factorized once and used for many solves.
template <class Number, int order>
class eliminated {
public:
  constexpr explicit eliminated(const fixed_matrix<Number, order, order>& m) {
    for (int i = 0; i < order; ++i)
      for (int j = 0; j < order; ++j) f_[place.at(i, j)] = m(i, j);
    factorize<math>(order, f_);
  }

  constexpr bool is_singular() const {
    return !(f_[place.least_pivot()] > math::template least_pivot<Number>);
  }
  /// Returns the reciprocal of a pivot.
  constexpr Number reciprocal(int k) const { return f_[place.at(k, k)]; }

  template <int columns>
  constexpr fixed_matrix<Number, order, columns> solve(fixed_matrix<Number, order, columns> b) const {
    fixed_matrix<Number, columns, order> rows = transposed(b); // stores B row by row
    solve_factorized<math, columns>(order, f_, rows.entries);
    return transposed(rows);
  }

private:
  using math = bounded_elimination_math;
  static constexpr factors place{order};
  Number f_[static_cast<std::size_t>(factors{order}.size())]{};
};

/// The factorization M = L D Lᵀ of a symmetric matrix. M is positive definite if all pivots are positive. The
/// result does not depend on the units of the rows.
template <class Number, int order>
class positive_factors {
public:
  constexpr explicit positive_factors(const fixed_matrix<Number, order, order>& m) : l_(m) {
    for (int k = 0; k < order; ++k) {
      const Number pivot = l_(k, k), least = Number(order) * std::numeric_limits<Number>::epsilon() * m(k, k);
      positive_ = positive_ && pivot > least && pivot > 0;
      if (!positive_) return;
      for (int i = k + 1; i < order; ++i) {
        const Number multiplier = l_(i, k) / pivot;
        for (int j = k + 1; j <= i; ++j) l_(i, j) -= multiplier * l_(j, k);
      }
      for (int i = k + 1; i < order; ++i) l_(i, k) /= pivot;
    }
  }

  constexpr explicit operator bool() const { return positive_; }

  /// Returns M⁻¹ B.
  template <int columns>
  constexpr fixed_matrix<Number, order, columns> solve(fixed_matrix<Number, order, columns> b) const {
    for (int c = 0; c < columns; ++c) {
      for (int k = 0; k < order; ++k)
        for (int i = k + 1; i < order; ++i) b(i, c) -= l_(i, k) * b(k, c);
      for (int k = order - 1; k >= 0; --k) {
        b(k, c) /= l_(k, k);
        for (int i = k + 1; i < order; ++i) b(k, c) -= l_(i, k) * b(i, c);
      }
    }
    return b;
  }

private:
  fixed_matrix<Number, order, order> l_; ///< with D on the diagonal
  bool positive_ = true;
};

} // namespace kanexpr::numeric
