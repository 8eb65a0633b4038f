#pragma once

#include <kanexpr/numeric/fixed_matrix.hpp>

#include <limits>

namespace kanexpr::numeric {

/// The factorization M = L D Lᵀ, with D ≥ 0, of a symmetric matrix that is positive semidefinite up to
/// rounding. The result does not depend on the units of the rows. Only the lower triangle of M is read.
///
/// The next pivot is the one that is largest relative to its entry on the diagonal of M. If it is below
/// `least` times that entry, the remainder is attributed to rounding and must be smaller than `rounding`; its
/// positive diagonal entries are kept.
template <class Number, int order>
class semidefinite_factors {
public:
  using square = fixed_matrix<Number, order, order>;

  constexpr semidefinite_factors(const square& m, Number least, Number rounding) : l_(m) {
    Number share[capacity]{}; // the reciprocal of the diagonal entry, or zero if the entry vanishes
    for (int i = 0; i < order; ++i) {
      row_[i] = i;
      share[i] = m(i, i) > (std::numeric_limits<Number>::min)() ? 1 / m(i, i) : Number(0);
    }
    for (int k = 0; k < order; ++k) {
      int next = k;
      Number most = l_(k, k) * share[k];
      for (int i = k + 1; i < order; ++i)
        if (const Number part = l_(i, i) * share[i]; part > most) next = i, most = part;
      if (next != k) exchange(k, next, share);
      const Number pivot = l_(k, k);
      if (most > least) {
        d_[k] = pivot;
        eliminate(k);
        continue;
      }
      d_[k] = pivot > 0 ? pivot : Number(0);
      discard_pivot(k, pivot, rounding, share);
    }
  }

  constexpr explicit operator bool() const { return is_valid_; }

  /// Returns A L.
  template <int rows>
  constexpr fixed_matrix<Number, rows, order> times_lower(const fixed_matrix<Number, rows, order>& a) const {
    fixed_matrix<Number, rows, order> product;
    for (int j = 0; j < order; ++j)
      for (int i = 0; i < rows; ++i) {
        Number sum = a(i, row_[j]);
        for (int k = j + 1; k < order; ++k) sum += a(i, row_[k]) * l_(k, j);
        product(i, j) = sum;
      }
    return product;
  }
  constexpr square lower() const {
    square l;
    for (int j = 0; j < order; ++j) {
      l(row_[j], j) = 1;
      for (int i = j + 1; i < order; ++i) l(row_[i], j) = l_(i, j);
    }
    return l;
  }

  /// Returns S + W D Wᵀ, reading the lower triangle of S. Without S, the result is a sum of squares: it is
  /// symmetric and has nonnegative diagonal entries; by the Cauchy-Schwarz inequality, the rounding error of
  /// each entry is at most a fraction of the square root of the product of the two diagonal entries.
  template <int rows>
  constexpr fixed_matrix<Number, rows, rows> squares(const fixed_matrix<Number, rows, order>& w,
                                                     fixed_matrix<Number, rows, rows> s = {}) const {
    for (int j = 0; j < rows; ++j) {
      Number weighted[capacity]{};
      for (int k = 0; k < order; ++k) weighted[k] = d_[k] * w(j, k);
      for (int i = j; i < rows; ++i) {
        for (int k = 0; k < order; ++k) s(i, j) += w(i, k) * weighted[k];
        s(j, i) = s(i, j);
      }
    }
    return s;
  }

private:
  static constexpr std::size_t capacity = fixed_matrix<Number, order, 1>::capacity;

  template <class Value>
  static constexpr void swap(Value& a, Value& b) {
    const Value kept = a;
    a = b, b = kept;
  }
  /// Exchanges two rows and columns, k < next.
  constexpr void exchange(int k, int next, Number (&share)[capacity]) {
    swap(row_[k], row_[next]);
    swap(share[k], share[next]);
    swap(l_(k, k), l_(next, next));
    for (int j = 0; j < k; ++j) swap(l_(k, j), l_(next, j));
    for (int j = k + 1; j < next; ++j) swap(l_(j, k), l_(next, j));
    for (int i = next + 1; i < order; ++i) swap(l_(i, k), l_(i, next));
  }
  constexpr void eliminate(int k) {
    Number left[capacity]{};
    for (int i = k + 1; i < order; ++i) left[i] = l_(i, k);
    for (int i = k + 1; i < order; ++i) {
      l_(i, k) = left[i] / d_[k];
      for (int j = k + 1; j <= i; ++j) l_(i, j) -= l_(i, k) * left[j];
    }
  }

  constexpr void discard_pivot(int k, Number pivot, Number rounding, const Number (&share)[capacity]) {
    constexpr Number smallest = (std::numeric_limits<Number>::min)();
    is_valid_ = is_valid_ && pivot * share[k] >= -rounding && (share[k] > 0 || pivot >= 0);
    for (int i = k + 1; i < order; ++i) {
      const Number off_diagonal = l_(i, k);
      is_valid_ =
          is_valid_ && (share[i] > 0 && share[k] > 0
                            ? off_diagonal * share[i] * (off_diagonal * share[k]) <= rounding * rounding
                            : constant_elimination_math::magnitude(off_diagonal) <= smallest);
      l_(i, k) = 0;
    }
  }

  square l_; ///< below the diagonal, with rows in pivot order
  Number d_[capacity]{};
  int row_[capacity]{};
  bool is_valid_ = true;
};

} // namespace kanexpr::numeric
