#pragma once

#include <kanexpr/control/balance.hpp>
#include <kanexpr/numeric/as_eigen.hpp>

#include <Eigen/Core>
#include <concepts>

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

} // namespace kanexpr::control
