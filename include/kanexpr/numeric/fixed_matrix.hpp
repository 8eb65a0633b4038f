#pragma once

#include <kanexpr/numeric/constant_elimination_math.hpp>
#include <kanexpr/numeric/elimination.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>

#include <cstddef>
#include <limits>
#include <type_traits>

namespace kanexpr::numeric {

/// A matrix for constant expressions, where Eigen's cannot go: `m(i, j)`, and a number where it is one.
/// The entries follow each other by columns, as Eigen has them.
template <class T, int rows, int columns>
struct fixed_matrix {
  static constexpr std::size_t room = rows * columns > 0 ? static_cast<std::size_t>(rows* columns) : 1;
  T entries[room]{};

  constexpr T& operator()(int i, int j = 0) { return entries[i + j * rows]; }
  constexpr const T& operator()(int i, int j = 0) const { return entries[i + j * rows]; }
  constexpr operator T() const
    requires(rows == 1 && columns == 1)
  {
    return entries[0];
  }

  /// The entries in some rows and columns: `m.at({1, 2}, {0})`.
  template <std::size_t r, std::size_t c>
  constexpr fixed_matrix<T, static_cast<int>(r), static_cast<int>(c)> at(const int (&in_rows)[r],
                                                                         const int (&in_columns)[c]) const {
    constexpr int height = static_cast<int>(r), width = static_cast<int>(c);
    fixed_matrix<T, height, width> part;
    for (int j = 0; j < width; ++j)
      for (int i = 0; i < height; ++i) part(i, j) = (*this)(in_rows[i], in_columns[j]);
    return part;
  }

  /// The same in other numbers: `K.cast<float>()`.
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
  friend constexpr fixed_matrix operator*(T factor, const fixed_matrix& a) {
    fixed_matrix c;
    for (int i = 0; i < rows * columns; ++i) c.entries[i] = factor * a.entries[i];
    return c;
  }
};

template <class T, int n, int m, int l>
constexpr fixed_matrix<T, n, l> operator*(const fixed_matrix<T, n, m>& a, const fixed_matrix<T, m, l>& b) {
  fixed_matrix<T, n, l> c;
  for (int j = 0; j < l; ++j)
    for (int k = 0; k < m; ++k) {
      const T factor = b.entries[k + j * m];
      for (int i = 0; i < n; ++i) c.entries[i + j * n] += a.entries[i + k * n] * factor;
    }
  return c;
}

/// The matrix that is written row by row, `by_rows({{1.0, 2.0}, {3.0, 4.0}})`.
template <class T, std::size_t rows, std::size_t columns>
constexpr fixed_matrix<T, static_cast<int>(rows), static_cast<int>(columns)>
by_rows(const T (&written)[rows][columns]) {
  constexpr int height = static_cast<int>(rows), width = static_cast<int>(columns);
  fixed_matrix<T, height, width> m;
  for (int i = 0; i < height; ++i)
    for (int j = 0; j < width; ++j) m(i, j) = written[i][j];
  return m;
}

template <class T, int n>
constexpr fixed_matrix<T, n, n> identity() {
  fixed_matrix<T, n, n> one;
  for (int i = 0; i < n; ++i) one(i, i) = 1;
  return one;
}

template <class T, int rows, int columns>
constexpr fixed_matrix<T, columns, rows> transposed(const fixed_matrix<T, rows, columns>& m) {
  fixed_matrix<T, columns, rows> t;
  for (int j = 0; j < columns; ++j)
    for (int i = 0; i < rows; ++i) t(j, i) = m(i, j);
  return t;
}

/// (M + Mᵀ)/2, of what is symmetric but for rounding.
template <class T, int n>
constexpr fixed_matrix<T, n, n> symmetric(const fixed_matrix<T, n, n>& m) {
  return T(0.5) * (m + transposed(m));
}

/// The largest magnitude of an entry; not a number where one is none.
template <class T, int rows, int columns>
constexpr T largest_entry(const fixed_matrix<T, rows, columns>& m) {
  T most = 0;
  for (int i = 0; i < rows * columns; ++i) {
    const T size = constant_elimination_math::magnitude(m.entries[i]);
    if (!(size <= most)) most = size;
    if (!is_number(most)) return most;
  }
  return most;
}

/// Whether all entries are finite, by their bits, so that it holds with -ffast-math.
template <class T, int rows, int columns>
constexpr bool is_finite(const fixed_matrix<T, rows, columns>& m) {
  for (int i = 0; i < rows * columns; ++i)
    if (!is_finite(m.entries[i])) return false;
  return true;
}

/// What a constant expression does must not overflow either: a pivot so small that it might vanishes, too.
struct bounded_elimination_math : constant_elimination_math {
  template <class T>
  static constexpr T least_pivot = power_of_two<T>(-std::numeric_limits<T>::max_exponent / 4);
  template <class T>
  static constexpr T reciprocal(T x) {
    return magnitude(x) > least_pivot<T> ? 1 / x : T(0);
  }
};

/// A matrix that is eliminated once, to solve with it many times.
template <class T, int n>
class eliminated {
public:
  constexpr explicit eliminated(const fixed_matrix<T, n, n>& m) {
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) f_[place.at(i, j)] = m(i, j);
    factorize<math>(n, f_);
  }

  constexpr bool is_singular() const { return !(f_[place.least_pivot()] > math::template least_pivot<T>); }
  /// One over a pivot.
  constexpr T reciprocal(int k) const { return f_[place.at(k, k)]; }

  template <int columns>
  constexpr fixed_matrix<T, n, columns> solve(fixed_matrix<T, n, columns> b) const {
    for (int j = 0; j < columns; ++j) solve_factorized<math>(n, f_, b.entries + j * n);
    return b;
  }

private:
  using math = bounded_elimination_math;
  static constexpr factors place{n};
  T f_[static_cast<std::size_t>(factors{n}.size())]{};
};

/// M = L D Lᵀ of a symmetric matrix, which is positive definite where every pivot is. In which units its rows
/// are does not matter.
template <class T, int n>
class positive_factors {
public:
  constexpr explicit positive_factors(const fixed_matrix<T, n, n>& m) : l_(m) {
    for (int k = 0; k < n; ++k) {
      const T pivot = l_(k, k), least = T(n) * std::numeric_limits<T>::epsilon() * m(k, k);
      positive_ = positive_ && pivot > least && pivot > 0;
      if (!positive_) return;
      for (int i = k + 1; i < n; ++i) {
        const T multiplier = l_(i, k) / pivot;
        for (int j = k + 1; j <= i; ++j) l_(i, j) -= multiplier * l_(j, k);
      }
      for (int i = k + 1; i < n; ++i) l_(i, k) /= pivot;
    }
  }

  constexpr explicit operator bool() const { return positive_; }

  /// M⁻¹ B.
  template <int columns>
  constexpr fixed_matrix<T, n, columns> solve(fixed_matrix<T, n, columns> b) const {
    for (int c = 0; c < columns; ++c) {
      for (int k = 0; k < n; ++k)
        for (int i = k + 1; i < n; ++i) b(i, c) -= l_(i, k) * b(k, c);
      for (int k = n - 1; k >= 0; --k) {
        b(k, c) /= l_(k, k);
        for (int i = k + 1; i < n; ++i) b(k, c) -= l_(i, k) * b(i, c);
      }
    }
    return b;
  }

private:
  fixed_matrix<T, n, n> l_; ///< D on the diagonal
  bool positive_ = true;
};

} // namespace kanexpr::numeric
