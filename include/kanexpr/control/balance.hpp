#pragma once

#include <kanexpr/numeric/fixed_matrix.hpp>

namespace kanexpr::control {

using numeric::fixed_matrix;

/// Units of the states, powers of two, so that scaling rounds nothing.
template <class T, int n>
struct units {
  T of[static_cast<std::size_t>(n > 0 ? n : 1)]{};

  constexpr units() {
    for (T& each : of) each = 1;
  }

  /// D⁻¹ M D of a matrix that takes states to states.
  constexpr fixed_matrix<T, n, n> scaled(fixed_matrix<T, n, n> m) const {
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) m(i, j) = m(i, j) / of[i] * of[j];
    return m;
  }
  /// D M D⁻¹.
  constexpr fixed_matrix<T, n, n> unscaled(fixed_matrix<T, n, n> m) const {
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) m(i, j) = m(i, j) * of[i] / of[j];
    return m;
  }
  /// D⁻¹ M, and D⁻¹ M D⁻¹.
  template <int columns>
  constexpr fixed_matrix<T, n, columns> divided(fixed_matrix<T, n, columns> m) const {
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < columns; ++j) m(i, j) /= of[i];
    return m;
  }
  constexpr fixed_matrix<T, n, n> divided_twice(const fixed_matrix<T, n, n>& m) const {
    return divided(numeric::transposed(divided(m)));
  }
  /// D M, and D M D.
  template <int columns>
  constexpr fixed_matrix<T, n, columns> multiplied(fixed_matrix<T, n, columns> m) const {
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < columns; ++j) m(i, j) *= of[i];
    return m;
  }
  constexpr fixed_matrix<T, n, n> multiplied_twice(const fixed_matrix<T, n, n>& m) const {
    return multiplied(numeric::transposed(multiplied(m)));
  }
};

/// What grows with a unit, in proportion and as its square, and what shrinks with it.
template <class T>
struct balance {
  T grows = 0, grows_twice = 0, shrinks = 0, shrinks_twice = 0;

  constexpr T at(T unit) const {
    return grows * unit + grows_twice * unit * unit + shrinks / unit + shrinks_twice / unit / unit;
  }
  /// The power of two at which the sum is least.
  constexpr T best() const {
    constexpr int most = 100; // doublings in one go; those that are left come next time
    T unit = 1;
    if (!(grows + grows_twice > 0) || !(shrinks + shrinks_twice > 0)) return unit;
    for (int i = 0; i < most && at(2 * unit) < at(unit); ++i) unit *= 2;
    for (int i = 0; i < most && at(unit / 2) < at(unit); ++i) unit /= 2;
    return unit;
  }
};

/// Units in which the entries of A, G and Q of a Riccati equation are alike: x = D z, A → D⁻¹ A D, G → D⁻¹ G
/// D⁻¹, Q → D Q D (Benner, Symplectic balancing of Hamiltonian matrices, SIAM J. Sci. Comput. 22, 2001).
/// Where G and Q are zero those in which A is balanced.
template <class T, int n>
constexpr units<T, n> balanced_units(const fixed_matrix<T, n, n>& a, const fixed_matrix<T, n, n>& g,
                                     const fixed_matrix<T, n, n>& q) {
  constexpr auto magnitude = [](T x) { return numeric::constant_elimination_math::magnitude(x); };
  constexpr int most_sweeps = 20;
  units<T, n> found;
  bool changes = true;
  for (int sweep = 0; sweep < most_sweeps && changes; ++sweep) {
    changes = false;
    balance<T> all;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        all.grows_twice += magnitude(q(i, j)) * found.of[i] * found.of[j];
        all.shrinks_twice += magnitude(g(i, j)) / found.of[i] / found.of[j];
      }
    const T common = all.best();
    for (int i = 0; i < n; ++i) found.of[i] *= common;
    for (int i = 0; i < n; ++i) {
      balance<T> one;
      const T own = found.of[i];
      for (int j = 0; j < n; ++j) {
        const T other = found.of[j];
        if (i == j) {
          one.grows_twice += magnitude(q(i, i)) * own * own;
          one.shrinks_twice += magnitude(g(i, i)) / own / own;
        } else {
          one.grows += magnitude(a(j, i)) / other * own + magnitude(q(i, j)) * own * other;
          one.shrinks += magnitude(a(i, j)) / own * other + magnitude(g(i, j)) / own / other;
        }
      }
      const T unit = one.best();
      if (one.at(unit) < T(0.95) * one.at(1)) {
        found.of[i] *= unit;
        changes = true;
      }
    }
  }
  return found;
}

} // namespace kanexpr::control
