#pragma once

#include <kanexpr/numeric/fixed_matrix.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>

#include <limits>

namespace kanexpr::control {

using numeric::fixed_matrix;

template <int rows, int columns>
using exponents = fixed_matrix<int, rows, columns>;

template <class Number, int rows, int columns>
constexpr exponents<rows, columns> exponents_of(const fixed_matrix<Number, rows, columns>& m) {
  exponents<rows, columns> found;
  for (int i = 0; i < rows * columns; ++i) found.entries[i] = numeric::exponent_of(m.entries[i]);
  return found;
}
template <int rows, int columns>
constexpr int largest_exponent(const exponents<rows, columns>& of) {
  int most = numeric::exponent_of_zero;
  for (int i = 0; i < rows * columns; ++i)
    if (of.entries[i] > most) most = of.entries[i];
  return most;
}

/// Units of states or inputs, x = D z, as powers of two with these exponents.
template <int order>
struct units {
  int of[static_cast<std::size_t>(order > 0 ? order : 1)]{};

  /// Returns Dʳ M D′ᶜ 2ᵏ with r = by_row and c = by_column, each 1 or −1. Scaling is exact unless an entry
  /// underflows; an entry that overflows becomes infinite.
  template <int by_row, int by_column, class Number, int others>
  constexpr fixed_matrix<Number, order, others> scaled(fixed_matrix<Number, order, others> matrix,
                                                       const units<others>& other, int k = 0) const {
    for (int i = 0; i < order; ++i)
      for (int j = 0; j < others; ++j)
        matrix(i, j) =
            numeric::times_power_of_two(matrix(i, j), by_row * of[i] + by_column * other.of[j] + k);
    return matrix;
  }
};

/// Returns the units in which the diagonal entries of a symmetric matrix have magnitudes between 1 and 4, or
/// are zero.
template <class Number, int order>
constexpr units<order> diagonal_units(const fixed_matrix<Number, order, order>& m) {
  units<order> found;
  for (int i = 0; i < order; ++i)
    if (const int exponent = numeric::exponent_of(m(i, i)); !numeric::is_exponent_of_zero(exponent))
      found.of[i] = -(exponent - (exponent & 1)) / 2;
  return found;
}

/// Whether an off-diagonal entry is so large in these units that the matrix has a negative eigenvalue.
template <class Number, int order>
constexpr bool exceeds_its_diagonal(const fixed_matrix<Number, order, order>& m) {
  for (int i = 0; i < order; ++i)
    for (int j = 0; j < order; ++j)
      if (numeric::exponent_of(m(i, j)) > 2) return true;
  return false;
}

/// Whether a symmetric matrix is positive definite.
template <class Number, int order>
constexpr bool is_positive_definite(const fixed_matrix<Number, order, order>& m) {
  const units<order> unit = diagonal_units(m);
  const fixed_matrix<Number, order, order> normalized = unit.template scaled<1, 1>(m, unit);
  return !exceeds_its_diagonal(normalized) &&
         static_cast<bool>(numeric::positive_factors<Number, order>(normalized));
}

/// The exponents of the quantities that grow with a unit, linearly or quadratically, and of those that
/// shrink.
struct balance {
  int grows = numeric::exponent_of_zero, grows_twice = grows, shrinks = grows, shrinks_twice = grows;

  constexpr bool any_grows() const { return !numeric::is_exponent_of_zero(larger(grows, grows_twice)); }
  constexpr bool any_shrinks() const { return !numeric::is_exponent_of_zero(larger(shrinks, shrinks_twice)); }

  /// Returns the number of powers of two by which the unit must change to make the largest growing and the
  /// largest shrinking quantity equal. If all quantities shrink, or all grow, the unit is limited by `least`.
  constexpr int best(int least) const {
    if (!any_grows() && !any_shrinks()) return 0;
    if (!any_grows()) return larger(0, larger(shrinks - least, (shrinks_twice - least + 1) / 2));
    if (!any_shrinks()) return -larger(0, larger(grows - least, (grows_twice - least + 1) / 2));
    return larger(-larger((grows - shrinks) / 2, (grows_twice - shrinks) / 3),
                  -larger((grows - shrinks_twice) / 3, (grows_twice - shrinks_twice) / 4));
  }

  static constexpr int larger(int a, int b) { return a > b ? a : b; }
};

/// Returns the units in which the entries of A, G and Q of a Riccati equation have similar magnitudes: x = D
/// z, A → D⁻¹ A D, G → D⁻¹ G D⁻¹, Q → D Q D (Benner, Symplectic balancing of Hamiltonian matrices, SIAM J.
/// Sci. Comput. 22, 2001). The computation uses the exponents only and cannot overflow. If G and Q are zero,
/// these units balance A. An entry with no counterpart is scaled down to `least`.
template <int order>
constexpr units<order> balanced_units(const exponents<order, order>& a, const exponents<order, order>& g,
                                      const exponents<order, order>& q, int least) {
  constexpr int most_sweeps = 20;
  units<order> found;
  const auto raise = [](int& most, int exponent) { most = balance::larger(most, exponent); };
  bool changes = true;
  for (int sweep = 0; sweep < most_sweeps && changes; ++sweep) {
    changes = false;
    balance all;
    for (int i = 0; i < order; ++i)
      for (int j = 0; j < order; ++j) {
        raise(all.grows_twice, q(i, j) + found.of[i] + found.of[j]);
        raise(all.shrinks_twice, g(i, j) - found.of[i] - found.of[j]);
      }
    const int common = all.any_grows() && all.any_shrinks() ? all.best(least) : 0;
    for (int i = 0; i < order; ++i) found.of[i] += common;
    for (int i = 0; i < order; ++i) {
      balance one;
      const int own = found.of[i];
      for (int j = 0; j < order; ++j) {
        const int other = found.of[j];
        if (i == j) {
          raise(one.grows_twice, q(i, i) + 2 * own);
          raise(one.shrinks_twice, g(i, i) - 2 * own);
        } else {
          raise(one.grows, balance::larger(a(j, i) - other, q(i, j) + other) + own);
          raise(one.shrinks, balance::larger(a(i, j) + other, g(i, j) - other) - own);
        }
      }
      const int change = one.best(least);
      found.of[i] += change;
      changes = changes || change != 0;
    }
  }
  return found;
}

} // namespace kanexpr::control
