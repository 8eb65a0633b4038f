#pragma once

#include <kanexpr/numeric/fixed_matrix.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>

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

/// Units of states or inputs, the powers of two of these exponents: x = D z.
template <int order>
struct units {
  int of[static_cast<std::size_t>(order > 0 ? order : 1)]{};

  /// Dʳ M D′ᶜ 2ᵏ with r by row and c by column, 1 or −1. Scaling rounds nothing, unless an entry becomes too
  /// small; one that becomes too large is infinite.
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

/// Units in which the magnitudes of the diagonal of a symmetric matrix are between 1 and 4, or zero.
template <class Number, int order>
constexpr units<order> diagonal_units(const fixed_matrix<Number, order, order>& m) {
  units<order> found;
  for (int i = 0; i < order; ++i)
    if (const int exponent = numeric::exponent_of(m(i, i)); !numeric::is_exponent_of_zero(exponent))
      found.of[i] = -(exponent - (exponent & 1)) / 2;
  return found;
}

/// Whether an entry beside the diagonal is so large, in these units, that the matrix has a negative
/// eigenvalue.
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

/// The exponents of what grows with a unit, in proportion and as its square, and of what shrinks with it.
struct balance {
  int grows = numeric::exponent_of_zero, grows_twice = grows, shrinks = grows, shrinks_twice = grows;

  constexpr bool any_grows() const { return !numeric::is_exponent_of_zero(larger(grows, grows_twice)); }
  constexpr bool any_shrinks() const { return !numeric::is_exponent_of_zero(larger(shrinks, shrinks_twice)); }

  /// By how many powers of two the unit has to change until the largest of what grows and of what shrinks are
  /// alike. Where all shrinks, or grows, it may as well be as small as something else.
  constexpr int best(int least) const {
    if (!any_grows() && !any_shrinks()) return 0;
    if (!any_grows()) return larger(0, larger(shrinks - least, (shrinks_twice - least + 1) / 2));
    if (!any_shrinks()) return -larger(0, larger(grows - least, (grows_twice - least + 1) / 2));
    return larger(-larger((grows - shrinks) / 2, (grows_twice - shrinks) / 3),
                  -larger((grows - shrinks_twice) / 3, (grows_twice - shrinks_twice) / 4));
  }

  static constexpr int larger(int a, int b) { return a > b ? a : b; }
};

/// Units in which the entries of A, G and Q of a Riccati equation are alike: x = D z, A → D⁻¹ A D, G → D⁻¹ G
/// D⁻¹, Q → D Q D (Benner, Symplectic balancing of Hamiltonian matrices, SIAM J. Sci. Comput. 22, 2001), by
/// their exponents, so that nothing is too large. Where G and Q are zero those in which A is balanced. What
/// nothing stands against becomes as small as `least`.
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
