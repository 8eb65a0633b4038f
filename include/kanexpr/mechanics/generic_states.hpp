#pragma once

#include <kanexpr/mechanics/mechanism.hpp>
#include <kanexpr/symbolic/elementary.hpp>
#include <kanexpr/symbolic/evaluate.hpp>
#include <kanexpr/symbolic/solve.hpp>

/// What holds in every configuration, found out by numbers: at a few states that nobody chose.
namespace kanexpr::mechanics {

/// A matrix of numbers by rows.
struct numbers {
  int rows = 0;
  int columns = 0;
  sequence<double> entries;

  constexpr double operator()(int i, int j) const { return entries[i * columns + j]; }
  constexpr bool finite() const {
    for (double e : entries)
      if (!symbolic::elementary::detail::is_finite(e)) return false;
    return true;
  }
};

/// A matrix of expressions at three generic states; fewer where a function is not defined there.
constexpr sequence<numbers> at_generic_states(const symbolic::matrix& a) {
  sequence<numbers> values;
  if (a.entries.empty()) return values;
  sequence<int> outputs;
  for (const expression& e : a.entries) outputs.push(e.node());
  const graph& g = a.entries[0].owner();
  symbolic::evaluation evaluate(g, outputs);
  std::uint64_t random = 88172645463325252u;
  for (int attempt = 0; attempt < 12 && values.size() < 3; ++attempt) {
    evaluate.at([&](int id) {
      random ^= random << 13, random ^= random >> 7, random ^= random << 17; // Marsaglia's xorshift
      const double between = static_cast<double>(random >> 11) / 9007199254740992.0;
      const bool one_sign = g.symbol_at(id).kind == symbolic::symbol_kind::parameter;
      return one_sign ? 0.5 + between : 1.8 * between - 0.9;
    });
    numbers found{a.rows, a.columns, {}};
    for (int id : outputs) found.entries.push(evaluate[id]);
    if (found.finite()) values.push(found);
  }
  return values;
}

/// Rows that were found independent, as an orthonormal basis.
class row_space {
public:
  /// Takes a row up; false where it lies in the space already.
  constexpr bool add(sequence<double> row) {
    const double whole = norm(row);
    if (whole < 1e-12) return false;        // what rounding leaves of zero
    for (int twice = 0; twice < 2; ++twice) // once more for what rounding left
      for (const sequence<double>& unit : basis_) {
        const double along = dot(unit, row);
        for (int j = 0; j < row.size(); ++j) row[j] -= along * unit[j];
      }
    const double left = norm(row);
    if (left <= 1e-9 * whole) return false;
    for (double& e : row) e /= left;
    basis_.push(row);
    return true;
  }

private:
  static constexpr double dot(const sequence<double>& a, const sequence<double>& b) {
    double sum = 0;
    for (int j = 0; j < a.size(); ++j) sum += a[j] * b[j];
    return sum;
  }
  static constexpr double norm(const sequence<double>& a) { return symbolic::elementary::sqrt(dot(a, a)); }

  sequence<sequence<double>> basis_;
};

/// Which rows of a matrix do not follow from those before them, in some configuration at least.
constexpr sequence<char> independent_rows(const symbolic::matrix& a) {
  const sequence<numbers> states = at_generic_states(a);
  sequence<row_space> spaces(states.size());
  sequence<char> independent;
  for (int i = 0; i < a.rows; ++i) {
    bool adds = states.empty(); // nothing is known
    for (int s = 0; s < states.size(); ++s) {
      sequence<double> row;
      for (int j = 0; j < a.columns; ++j) row.push(states[s](i, j));
      if (spaces[s].add(row)) adds = true;
    }
    independent.push(adds ? 1 : 0);
  }
  return independent;
}

} // namespace kanexpr::mechanics
