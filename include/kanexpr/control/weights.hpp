#pragma once

#include <kanexpr/control/balance.hpp>
#include <kanexpr/numeric/as_eigen.hpp>

#include <concepts>

namespace kanexpr::control {

using numeric::fixed_matrix;

/// The weights of n states or inputs in a quadratic cost: their diagonal, `{1, 1, 0.1, 0.1}`, or a matrix, or
/// a vector of Eigen as a diagonal.
template <class Entry, int order>
struct weights {
  fixed_matrix<Entry, order, order> matrix{};

  template <class... Number>
    requires(sizeof...(Number) > 0 && (std::convertible_to<const Number&, Entry> && ...))
  constexpr weights(const Number&... diagonal) {
    static_assert(order < 0 || sizeof...(Number) == order,
                  "a diagonal of weights has a number for each state, or each input");
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
  /// Whether a matrix is one of weights; where it is not, the end of the compilation.
  template <class Other, int rows, int columns>
  static constexpr bool are_fitting() {
    constexpr bool is_known = rows >= 0 && columns >= 0,
                   fits = order < 0 || (rows == order &&
                                        (columns == 1 || columns == order)), // of A another sentence tells
        is_exact = std::numeric_limits<Other>::digits <= std::numeric_limits<Entry>::digits;
    static_assert(is_known, "the size of the weights must be known to the compiler");
    static_assert(
        !is_known || fits,
        "weights are a square matrix of as many rows as there are states, or inputs, or its diagonal");
    static_assert(!is_known || !fits || is_exact, "the weights have more digits than the numbers of A and B");
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

/// Symmetric but for rounding.
template <class Entry, int order>
constexpr bool is_symmetric(const fixed_matrix<Entry, order, order>& m) {
  constexpr auto magnitude = [](Entry x) { return numeric::constant_elimination_math::magnitude(x); };
  for (int i = 0; i < order; ++i)
    for (int j = 0; j < i; ++j) {
      if (numeric::equal(m(i, j), m(j, i))) continue;
      if (const Entry one = m(i, j) / 4, other = m(j, i) / 4; // their sum and difference do not overflow
          magnitude(one - other) >
          64 * std::numeric_limits<Entry>::epsilon() * (magnitude(one) + magnitude(other)))
        return false;
    }
  return true;
}

/// Whether a symmetric matrix is positive semidefinite but for rounding, whatever the units of its rows: it
/// is eliminated with the pivot next that is largest beside its entry.
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
      // Of what is left the diagonal is rounding; so must be all beside it.
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
