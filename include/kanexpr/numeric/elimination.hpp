#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/numeric/elementary.hpp>

/// Gaussian elimination with row exchanges and without branches on values: rows are compared and exchanged by
/// selection. The order of operations is the same wherever a system is solved; lower/unrolled_elimination.hpp
/// unrolls it.
namespace kanexpr::numeric {

/// The layout of a factorization of a given order: first the matrix in row-major order, with the multipliers
/// below the diagonal and the reciprocals of the pivots on it; then, for each comparison of two rows, the
/// excess of the lower row (positive if they were exchanged); then the smallest magnitude of a pivot.
struct factors {
  int order = 0;

  constexpr int at(int i, int j) const { return i * order + j; }
  constexpr int excess(int upper, int lower) const {
    return order * order + upper * (2 * order - upper - 1) / 2 + lower - upper - 1;
  }
  constexpr int least_pivot() const { return order * order + order * (order - 1) / 2; }
  constexpr int size() const { return least_pivot() + 1; }
};

namespace detail {

/// Subtracts a multiple of a row.
template <int columns, class Number>
constexpr void subtract(Number* __restrict from, const Number factor, const Number* __restrict row) {
  for (int c = 0; c < columns; ++c) from[c] = Number(from[c] - Number(factor * row[c]));
}

} // namespace detail

/// Factorizes the matrix at the start of `f`. `Math` provides `magnitude`, `reciprocal` and
/// `exchange_if_positive(d, a, b)`.
template <class Math, class Number>
constexpr void factorize(int order, Number* f) {
  const factors place{order};
  Number least = f[0];
  for (int k = 0; k < order; ++k) {
    for (int i = k + 1; i < order; ++i) {
      const Number lower = Math::magnitude(f[place.at(i, k)]), upper = Math::magnitude(f[place.at(k, k)]);
      const Number excess = f[place.excess(k, i)] = Number(lower - upper);
      for (int j = k; j < order; ++j)
        Math::exchange_if_positive(excess, f[place.at(k, j)], f[place.at(i, j)]);
    }
    Number& pivot = f[place.at(k, k)];
    Number size = Math::magnitude(pivot);
    if (k == 0)
      least = size;
    else
      Math::exchange_if_positive(Number(least - size), least, size);
    pivot = Math::reciprocal(pivot);
    for (int i = k + 1; i < order; ++i) {
      const Number multiplier = f[place.at(i, k)] = Number(f[place.at(i, k)] * pivot);
      for (int j = k + 1; j < order; ++j)
        f[place.at(i, j)] = Number(f[place.at(i, j)] - Number(multiplier * f[place.at(k, j)]));
    }
  }
  f[place.least_pivot()] = least;
}

/// Solves A X = B for several columns side by side, with B passed in x row by row. Each column takes the same
/// operations as one alone.
template <class Math, int columns = 1, class Number>
constexpr void solve_factorized(int order, const Number* f, Number* x) {
  const factors place{order};
  for (int k = 0; k < order; ++k) {
    Number* const pivot = x + k * columns;
    for (int i = k + 1; i < order; ++i) {
      const Number excess = f[place.excess(k, i)];
      Number* const row = x + i * columns;
      for (int c = 0; c < columns; ++c) Math::exchange_if_positive(excess, pivot[c], row[c]);
    }
    for (int i = k + 1; i < order; ++i) detail::subtract<columns>(x + i * columns, f[place.at(i, k)], pivot);
  }
  for (int done = 0; done < order; ++done) {
    const int k = order - 1 - done;
    Number* const row = x + k * columns;
    for (int j = k + 1; j < order; ++j) detail::subtract<columns>(row, f[place.at(k, j)], x + j * columns);
    const Number inverse = f[place.at(k, k)];
    for (int c = 0; c < columns; ++c) row[c] = Number(row[c] * inverse);
  }
}

/// Solves Aᵀ x = b by the transposed steps in reverse order.
template <class Math, class Number>
constexpr void solve_transposed_factorized(int order, const Number* f, Number* x) {
  const factors place{order};
  for (int k = 0; k < order; ++k) {
    x[k] = Number(x[k] * f[place.at(k, k)]);
    for (int j = k + 1; j < order; ++j) x[j] = Number(x[j] - Number(f[place.at(k, j)] * x[k]));
  }
  for (int done = 0; done < order; ++done) {
    const int k = order - 1 - done;
    for (int i = k + 1; i < order; ++i) x[k] = Number(x[k] - Number(f[place.at(i, k)] * x[i]));
    for (int i = order - 1; i > k; --i) Math::exchange_if_positive(f[place.excess(k, i)], x[k], x[i]);
  }
}

/// Returns the smallest pivot relative to the terms that add up to it: elimination is applied to `squares`,
/// the squared sizes of the entries in row-major order, without cancellation. Each size has the unit of its
/// entry, so the units of rows and columns do not matter. NaN propagates.
template <class Math, class Number>
constexpr Number singularity_measure_of(int order, const Number* f, Number* squares) {
  const factors place{order};
  Number largest = f[0]; // overwritten by the first pivot
  for (int k = 0; k < order; ++k) {
    for (int i = k + 1; i < order; ++i)
      for (int j = k; j < order; ++j)
        Math::exchange_if_positive(f[place.excess(k, i)], squares[place.at(k, j)], squares[place.at(i, j)]);
    const Number& inverse = f[place.at(k, k)];
    Number own = Number(inverse * Number(inverse * squares[place.at(k, k)]));
    if (k > 0) Math::exchange_if_positive(Number(largest - own), own, largest);
    largest = own;
    for (int i = k + 1; i < order; ++i) {
      const Number square = Number(f[place.at(i, k)] * f[place.at(i, k)]);
      for (int j = k + 1; j < order; ++j)
        squares[place.at(i, j)] = Number(squares[place.at(i, j)] + Number(square * squares[place.at(k, j)]));
    }
  }
  Number least = f[place.least_pivot()], beside = Math::root(Math::reciprocal(largest));
  Math::exchange_if_positive(f[place.least_pivot()], least, beside);
  return least; // if a pivot is zero, the entries that follow it are NaN
}

/// The scalar operations for elimination in a constant expression. A constant expression must not divide by
/// zero, so a vanishing pivot is skipped; callers check the smallest pivot first.
struct constant_elimination_math {
  template <class Number>
  static constexpr Number magnitude(Number x) {
    return x < 0 ? -x : x;
  }
  template <class Number>
  static constexpr Number reciprocal(Number x) {
    return base::equal(x, Number(0)) ? Number(0) : 1 / x;
  }
  static constexpr double root(double x) { return numeric::elementary::sqrt(x); }
  template <class Number>
  static constexpr void exchange_if_positive(Number d, Number& a, Number& b) {
    if (!(d > 0)) return;
    const Number kept = a;
    a = b;
    b = kept;
  }
};

} // namespace kanexpr::numeric
