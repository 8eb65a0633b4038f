#pragma once

#include <kanexpr/base/sequence.hpp>

/// The solution of M X = B for several columns at once, where M = LᵀDL is symmetric and already factorized.
///
/// A column takes the same operations as every other one: B is nonzero in a row if it is in any column. The
/// order of operations is the same wherever such a system is solved; lower/vector_columns.hpp evaluates
/// several columns as vectors.
namespace kanexpr::numeric {

/// The layout of the factors: for each unknown, in the order of elimination, the reciprocal of its pivot,
/// followed by its multipliers for the unknowns that are eliminated later.
struct symmetric_factors {
  int order = 0;

  constexpr int at(int pivot, int later) const {
    return pivot * order - pivot * (pivot - 1) / 2 + later - pivot;
  }
  constexpr int size() const { return order * (order + 1) / 2; }
  /// The order of the system with so many factors.
  static constexpr int order_of(int size) {
    int order = 0;
    while (symmetric_factors{order}.size() < size) ++order;
    return order;
  }
};

/// One step of the solution for a column x: the entry `to` becomes `to − factor · from`, or −factor · from if
/// it is zero before, or, for a pivot, factor · from.
struct column_step {
  int to = 0, from = 0, factor = 0;
  bool fills = false;

  constexpr bool is_pivot() const { return to == from; }
};

/// The steps that structural zeros leave over.
struct column_steps {
  base::sequence<column_step> all{};
  base::sequence<char> filled{}; ///< whether each unknown may differ from zero

  constexpr column_steps() = default;
  /// `is_zero(i)` returns whether a factor is zero, `is_zero_row(i)` whether a row of B is.
  template <class IsZero, class IsZeroRow>
  constexpr column_steps(int order, const IsZero& is_zero, const IsZeroRow& is_zero_row) {
    const symmetric_factors place{order};
    filled.resize(order, 0);
    for (int i = 0; i < order; ++i) filled[i] = is_zero_row(i) ? 0 : 1;
    const auto update = [&](int to, int from, int factor) {
      if (filled[from] == 0 || is_zero(factor)) return;
      all.push({to, from, factor, filled[to] == 0});
      filled[to] = 1;
    };
    for (int p = 0; p < order; ++p)
      for (int i = p + 1; i < order; ++i) update(i, p, place.at(p, i));
    for (int p = order - 1; p >= 0; --p) {
      if (filled[p] != 0) all.push({p, p, place.at(p, p), false});
      for (int i = p + 1; i < order; ++i) update(p, i, place.at(p, i));
    }
  }
};

/// Solves for one column, whose entries are `stride` apart. Entries that no step reaches keep their value.
template <class Number>
constexpr void solve_column(const column_steps& steps, const Number* factors, Number* x, int stride) {
  for (const column_step& s : steps.all) {
    const int target = s.to * stride, source = s.from * stride;
    Number& to = x[target];
    const Number& from = x[source];
    if (s.is_pivot())
      to = Number(from * factors[s.factor]);
    else if (s.fills)
      to = Number(-Number(factors[s.factor] * from));
    else
      to = Number(to - Number(factors[s.factor] * from));
  }
}

} // namespace kanexpr::numeric
