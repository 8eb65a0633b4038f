#pragma once

#include <kanexpr/control/balance.hpp>
#include <kanexpr/numeric/as_eigen.hpp>

#include <Eigen/Core>
#include <concepts>
#include <limits>

namespace kanexpr::control {

using numeric::fixed_matrix;

/// The weights of n states or inputs in a quadratic cost: given by the diagonal as a list `{1, 1, 0.1, 0.1}`
/// or as an Eigen vector, or by a square matrix.
template <class Entry, int order>
struct weights {
  fixed_matrix<Entry, order, order> matrix{};

  template <class... Number>
    requires(sizeof...(Number) > 0 && (std::convertible_to<const Number&, Entry> && ...))
  constexpr weights(const Number&... diagonal) {
    static_assert(order < 0 || sizeof...(Number) == order,
                  "a diagonal of weights must have one entry for each state, or each input");
    if constexpr (sizeof...(Number) == order) {
      int i = 0;
      ((matrix(i, i) = static_cast<Entry>(diagonal), ++i), ...);
    }
  }
  constexpr weights(const fixed_matrix<Entry, order, order>& all) : matrix(all) {}
  template <class Other, int rows, int columns>
  constexpr weights(const fixed_matrix<Other, rows, columns>& all) {
    if constexpr (are_fitting<Other, rows, columns>()) take(all);
  }
  template <class Derived>
  weights(const Eigen::MatrixBase<Derived>& all) {
    constexpr int rows = Derived::RowsAtCompileTime, columns = Derived::ColsAtCompileTime;
    if constexpr (are_fitting<typename Derived::Scalar, rows, columns>()) take(numeric::as_fixed(all));
  }

private:
  /// Whether a matrix can contain weights; a static assertion fails if it cannot.
  template <class Other, int rows, int columns>
  static constexpr bool are_fitting() {
    constexpr bool is_known = rows >= 0 && columns >= 0,
                   fits = order < 0 || (rows == order &&
                                        (columns == 1 || columns == order)), // a separate message covers A
        is_exact = std::numeric_limits<Other>::digits <= std::numeric_limits<Entry>::digits;
    static_assert(is_known, "the size of the weights must be known at compile time");
    static_assert(
        !is_known || fits,
        "the weights must be a square matrix with one row for each state, or each input, or its diagonal");
    static_assert(!is_known || !fits || is_exact,
                  "the scalar type of the weights is wider than that of A and B");
    return is_known && fits && is_exact && order >= 0;
  }

  template <class Other, int columns>
  constexpr void take(const fixed_matrix<Other, order, columns>& all) {
    for (int i = 0; i < order; ++i)
      for (int j = 0; j < order; ++j)
        if constexpr (columns == 1)
          matrix(i, j) = i == j ? static_cast<Entry>(all(i)) : Entry(0);
        else
          matrix(i, j) = static_cast<Entry>(all(i, j));
  }
};

/// Whether a matrix is symmetric up to rounding.
template <class Entry, int order>
constexpr bool is_symmetric(const fixed_matrix<Entry, order, order>& m) {
  constexpr auto magnitude = [](Entry x) { return numeric::constant_elimination_math::magnitude(x); };
  for (int i = 0; i < order; ++i)
    for (int j = 0; j < i; ++j) {
      if (base::equal(m(i, j), m(j, i))) continue;
      if (const Entry one = m(i, j) / 4, other = m(j, i) / 4; // their sum and difference do not overflow
          magnitude(one - other) >
          64 * std::numeric_limits<Entry>::epsilon() * (magnitude(one) + magnitude(other)))
        return false;
    }
  return true;
}

/// Whether a symmetric matrix is positive semidefinite up to rounding, regardless of the units of its rows.
/// Each elimination step takes the pivot that is largest relative to its original entry.
template <class Entry, int order>
constexpr bool is_positive_semidefinite(fixed_matrix<Entry, order, order> m) {
  const units<order> unit = diagonal_units(m);
  m = unit.template scaled<1, 1>(m, unit);
  if (exceeds_its_diagonal(m)) return false;
  const fixed_matrix<Entry, order, order> given = m;
  const Entry rounding = 8 * Entry(order) * std::numeric_limits<Entry>::epsilon();
  bool done[static_cast<std::size_t>(order > 0 ? order : 1)]{};
  for (int step = 0; step < order; ++step) {
    int next = -1;
    for (int i = 0; i < order; ++i) {
      if (done[i]) continue;
      if (!(m(i, i) >= -rounding * given(i, i))) return false;
      if (next < 0 || m(i, i) * given(next, next) > m(next, next) * given(i, i)) next = i;
    }
    const Entry pivot = m(next, next);
    done[next] = true;
    if (!(pivot > rounding * given(next, next))) {
      // The remaining diagonal entries are rounding errors, so the remaining off-diagonal entries must be,
      // too.
      for (int i = 0; i < order; ++i) {
        if (done[i] || m(i, next) == 0) continue;
        if (given(i, i) == 0 || given(next, next) == 0) return false;
        if (m(i, next) / given(i, i) * (m(i, next) / given(next, next)) > rounding) return false;
      }
      continue;
    }
    for (int i = 0; i < order; ++i)
      for (int j = 0; j < order; ++j)
        if (!done[i] && !done[j]) m(i, j) -= m(i, next) / pivot * m(next, j);
  }
  return true;
}

} // namespace kanexpr::control
