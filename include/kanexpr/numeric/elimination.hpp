#pragma once

/// Gaussian elimination with row exchanges, without a branch on a value: rows are compared and exchanged by
/// selection. What is done in which order is the same wherever a system is solved;
/// lower/unrolled_elimination.hpp unrolls it.
namespace kanexpr::numeric {

/// Where a factorization of some order keeps what: first the matrix by rows, with the multipliers below the
/// diagonal and the reciprocals of the pivots on it, then by how much the lower row was larger wherever two
/// rows were compared (positive: they were exchanged), then the least magnitude of a pivot.
struct factors {
  int order = 0;

  constexpr int at(int i, int j) const { return i * order + j; }
  constexpr int excess(int upper, int lower) const {
    return order * order + upper * (2 * order - upper - 1) / 2 + lower - upper - 1;
  }
  constexpr int least_pivot() const { return order * order + order * (order - 1) / 2; }
  constexpr int size() const { return least_pivot() + 1; }
};

/// Factorizes the matrix with which `f` begins. `Math` has `magnitude`, `reciprocal` and
/// `exchange_if_positive(d, a, b)`.
template <class Math, class Number>
constexpr void factorize(int order, Number* f) {
  const factors place{order};
  Number least = f[0];
  for (int k = 0; k < order; ++k) {
    for (int i = k + 1; i < order; ++i) {
      Number& excess = f[place.excess(k, i)];
      const Number lower = Math::magnitude(f[place.at(i, k)]), upper = Math::magnitude(f[place.at(k, k)]);
      excess = Number(lower - upper);
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
      Number& multiplier = f[place.at(i, k)];
      multiplier = Number(multiplier * pivot);
      for (int j = k + 1; j < order; ++j)
        f[place.at(i, j)] = Number(f[place.at(i, j)] - Number(multiplier * f[place.at(k, j)]));
    }
  }
  f[place.least_pivot()] = least;
}

/// Solves A x = b, where x is b to begin with.
template <class Math, class Number>
constexpr void solve_factorized(int order, const Number* f, Number* x) {
  const factors place{order};
  for (int k = 0; k < order; ++k) {
    for (int i = k + 1; i < order; ++i) Math::exchange_if_positive(f[place.excess(k, i)], x[k], x[i]);
    for (int i = k + 1; i < order; ++i) x[i] = Number(x[i] - Number(f[place.at(i, k)] * x[k]));
  }
  for (int done = 0; done < order; ++done) {
    const int k = order - 1 - done;
    for (int j = k + 1; j < order; ++j) x[k] = Number(x[k] - Number(f[place.at(k, j)] * x[j]));
    x[k] = Number(x[k] * f[place.at(k, k)]);
  }
}

/// Solves Aᵀ x = b: the same steps, transposed and in the opposite order.
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

/// The least of the pivots beside the terms that each is the sum of: what elimination does to the entries is
/// done to `squares` of their sizes, by rows, without a cancellation. Each has the unit of its entry, so it
/// does not matter in which units rows and columns are. What is not a number remains none.
template <class Math, class Number>
constexpr Number singularity_measure_of(int order, const Number* f, Number* squares) {
  const factors place{order};
  Number largest = f[0]; // overwritten by the first
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
  return least; // where a pivot is zero, what comes behind it is not a number
}

} // namespace kanexpr::numeric
