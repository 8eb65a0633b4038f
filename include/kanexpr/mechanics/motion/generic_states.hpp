#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/numeric/elementary.hpp>
#include <kanexpr/symbolic/graph/evaluate.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>
#include <kanexpr/symbolic/linear/solve.hpp>
#include <kanexpr/symbolic/sizes/magnitudes.hpp>
#include <kanexpr/symbolic/sizes/typical_sizes.hpp>

#include <limits>

/// Properties that hold in every configuration, tested numerically at a few generic states.
namespace kanexpr::mechanics {

/// A matrix of numbers, stored in row-major order.
struct numbers {
  int rows = 0;
  int columns = 0;
  sequence<double> entries{};

  constexpr double operator()(int i, int j) const { return entries[i * columns + j]; }
  constexpr sequence<double> row(int i) const {
    sequence<double> found;
    for (int j = 0; j < columns; ++j) found.push((*this)(i, j));
    return found;
  }
  constexpr bool finite() const {
    for (double e : entries)
      if (!numeric::elementary::detail::is_finite(e)) return false;
    return true;
  }
};

/// Random numbers between 0 and 1 by Marsaglia's xorshift, the same in every derivation.
class random_numbers {
public:
  constexpr explicit random_numbers(std::uint64_t seed = 88172645463325252u) : state_(seed) {}

  constexpr double next() {
    state_ ^= state_ << 13, state_ ^= state_ >> 7, state_ ^= state_ << 17;
    return static_cast<double>(state_ >> 11) / 9007199254740992.0;
  }

private:
  std::uint64_t state_;
};

namespace detail {

/// Marks the nodes that occur in arguments of functions, such as angles.
constexpr sequence<char> parts_of_arguments(const graph& g, const sequence<int>& live) {
  using symbolic::operation;
  sequence<char> found(g.size(), 0);
  for (int i = live.size() - 1; i >= 0; --i) {
    const symbolic::node& n = g[live[i]];
    if (symbolic::is_leaf(n.op) || n.op >= operation::pair) continue;
    if (found[live[i]] == 0 && (n.op < operation::sin || n.op > operation::log)) continue;
    found[n.a] = 1;
    if (symbolic::is_binary(n.op)) found[n.b] = 1;
  }
  return found;
}

/// A special value of `relative_size`: all symbols have magnitude 1, whatever their units.
inline constexpr double unit_sizes = 0;

/// Random values of symbols, with magnitudes comparable to those of the terms to which they are added;
/// quaternions have norm 1.
class generic_values {
public:
  constexpr generic_values(const graph& g, const sequence<int>& live, const mechanism* of,
                           double relative_size)
      : g_(g), of_(of) {
    const symbolic::typical_sizes sizes(g);
    for (int id : live)
      if (g[id].op == symbolic::operation::symbol) symbols_.push(id), size_.push(sizes[id]);
    if (of != nullptr)
      for (const frame& f : of->frames) complete(f.quaternion);
    value_.resize(symbols_.size(), 0.0);
    if (base::equal(relative_size, 1.0)) return;
    if (base::equal(relative_size, unit_sizes)) {
      for (double& size : size_) size = 1;
      return;
    }
    const sequence<char> is_angle = parts_of_arguments(g, live);
    for (int i = 0; i < symbols_.size(); ++i)
      if (is_angle[symbols_[i]] == 0) size_[i] *= relative_size;
  }
  generic_values(const generic_values&) = delete;
  generic_values& operator=(const generic_values&) = delete;

  constexpr void draw() {
    for (int i = 0; i < symbols_.size(); ++i) {
      const double next = random_.next();
      const bool one_sign = g_.symbol_at(symbols_[i]).kind == symbolic::symbol_kind::parameter;
      value_[i] = size_[i] * (one_sign ? 0.5 + next : 1.8 * next - 0.9);
    }
    if (of_ == nullptr) return;
    for (const frame& f : of_->frames) {
      double square = 0;
      for (const expression& e : f.quaternion)
        if (const int i = symbols_.find(e.node()); i >= 0) square += value_[i] * value_[i];
      for (const expression& e : f.quaternion)
        if (const int i = symbols_.find(e.node()); i >= 0) value_[i] /= numeric::elementary::sqrt(square);
    }
  }
  constexpr double operator[](int symbol) const { return value_[symbols_.find(symbol)]; }

private:
  /// If some entries of a quaternion are used, adds the others, because they contribute to its norm.
  constexpr void complete(const sequence<expression>& quaternion) {
    bool any = false;
    for (const expression& e : quaternion) any = any || symbols_.contains(e.node());
    for (const expression& e : quaternion)
      if (any && g_[e.node()].op == symbolic::operation::symbol && !symbols_.contains(e.node()))
        symbols_.push(e.node()), size_.push(1);
  }

  const graph& g_;
  const mechanism* of_;
  sequence<int> symbols_{};
  sequence<double> size_{}, value_{};
  random_numbers random_{};
};

} // namespace detail

/// Evaluates a matrix of expressions at three generic states, or fewer if functions are undefined at some of
/// them. Entries that are zero up to rounding, or subnormal, are set to zero. If a mechanism is given, its
/// quaternions have norm 1. The magnitudes of symbols that are not part of an angle are multiplied by
/// `relative_size`.
constexpr sequence<numbers> at_generic_states(const symbolic::matrix& a, const mechanism* of = nullptr,
                                              double relative_size = 1) {
  sequence<numbers> values;
  if (a.entries.empty()) return values;
  const sequence<int> outputs = symbolic::nodes_of(a.entries);
  const graph& g = a.entries[0].owner();
  symbolic::evaluation evaluate(g, outputs);
  sequence<bool> is_nothing;
  detail::generic_values generic(g, evaluate.live(), of, relative_size);
  for (int attempt = 0; attempt < 12 && values.size() < 3; ++attempt) {
    generic.draw();
    evaluate.at([&](int id) { return generic[id]; });
    numbers found{a.rows, a.columns, {}};
    for (int id : outputs) found.entries.push(evaluate[id]);
    if (!found.finite()) continue;
    if (values.empty()) { // an entry that is zero at one generic state is zero at all states
      const symbolic::magnitudes terms(g, evaluate);
      for (int i = 0; i < outputs.size(); ++i)
        is_nothing.push(terms.is_rounding_residue(outputs[i], found.entries[i]));
    }
    for (int i = 0; i < outputs.size(); ++i)
      if (is_nothing[i] || numeric::elementary::abs(found.entries[i]) < (std::numeric_limits<double>::min)())
        found.entries[i] = 0;
    values.push(found);
  }
  return values;
}

/// Scales rows and columns by the same factors at all states, so that the largest entry of each is near 1.
/// The result does not depend on the units of rows and columns: initial scales are propagated along a tree of
/// rows and columns that is determined by the sparsity pattern only.
class equilibration {
public:
  constexpr explicit equilibration(const sequence<numbers>& states) {
    if (states.empty()) return;
    largest_ = states[0];
    for (const numbers& a : states)
      for (int i = 0; i < a.entries.size(); ++i) {
        const double size = numeric::elementary::abs(a.entries[i]);
        double& so_far = largest_.entries[i];
        so_far = numeric::elementary::abs(so_far);
        if (size > so_far) so_far = size;
      }
    rows_.resize(largest_.rows, 0.0), columns_.resize(largest_.columns, 0.0);
    for (int i = 0; i < largest_.rows; ++i)
      if (base::equal(rows_[i], 0.0)) rows_[i] = 1, propagate(i);
    for (int sweeps = 0; sweeps < 2; ++sweeps) scale(columns_, rows_, false), scale(rows_, columns_, true);
  }

  constexpr void apply(numbers& a) const {
    for (int i = 0; i < a.rows; ++i)
      for (int j = 0; j < a.columns; ++j) a.entries[i * a.columns + j] *= rows_[i] * columns_[j];
  }

private:
  /// Divides the scale of each row, or of each column, by its largest entry.
  constexpr void scale(sequence<double>& scales, const sequence<double>& across, bool are_rows) const {
    for (int i = 0; i < scales.size(); ++i) {
      double most = 0;
      for (int j = 0; j < across.size(); ++j)
        if (const double entry = are_rows ? scaled(i, j) : scaled(j, i); entry > most) most = entry;
      if (most > 0) scales[i] /= most;
    }
  }

  constexpr double scaled(int i, int j) const { return largest_(i, j) * rows_[i] * columns_[j]; }

  /// Propagates the scale of a row to its columns, and from these to their rows.
  constexpr void propagate(int row) {
    for (int j = 0; j < largest_.columns; ++j) {
      if (!base::equal(columns_[j], 0.0) || base::equal(largest_(row, j), 0.0)) continue;
      columns_[j] = 1 / (largest_(row, j) * rows_[row]);
      for (int i = 0; i < largest_.rows; ++i)
        if (base::equal(rows_[i], 0.0) && !base::equal(largest_(i, j), 0.0))
          rows_[i] = 1 / (largest_(i, j) * columns_[j]), propagate(i);
    }
  }

  numbers largest_{}; ///< the largest over all states
  sequence<double> rows_{}, columns_{};
};

constexpr sequence<numbers> equilibrated(sequence<numbers> states) {
  const equilibration scale(states);
  for (numbers& a : states) scale.apply(a);
  return states;
}

/// Factors for typical magnitudes that are tried before a model is rejected, because the model may specify
/// too little about the magnitudes of its symbols.
inline constexpr double trial_sizes[]{detail::unit_sizes, 1e-3, 1e3, 1e-6, 1e6, 1e-9, 1e9, 1e-12};
inline constexpr double clearly = 1e-5; ///< tolerance for these trials, relative to the whole

/// The space spanned by the rows found independent, stored as an orthonormal basis. A row may be an equation
/// with a right-hand side.
class row_space {
public:
  constexpr explicit row_space(double least = 1e-9) : least_(least) {}

  /// Adds a row to the basis; returns false if the row already lies in the space.
  constexpr bool add(sequence<double> row, double right = 0) {
    const double whole = norm(row);
    if (base::equal(whole, 0.0)) return false;
    for (int twice = 0; twice < 2; ++twice) // repeated to remove rounding errors
      for (int i = 0; i < basis_.size(); ++i) {
        const double along = dot(basis_[i], row);
        for (int j = 0; j < row.size(); ++j) row[j] -= along * basis_[i][j];
        right -= along * right_[i];
      }
    const double left = norm(row);
    if (left <= least_ * whole) return false;
    for (double& e : row) e /= left;
    basis_.push(row), right_.push(right / left);
    return true;
  }

  /// The minimum-norm solution of the equations that were added, with `size` unknowns.
  constexpr sequence<double> solution(int size) const {
    sequence<double> x(size, 0.0);
    for (int i = 0; i < basis_.size(); ++i)
      for (int j = 0; j < size; ++j) x[j] += right_[i] * basis_[i][j];
    return x;
  }

private:
  static constexpr double dot(const sequence<double>& a, const sequence<double>& b) {
    double sum = 0;
    for (int j = 0; j < a.size(); ++j) sum += a[j] * b[j];
    return sum;
  }
  static constexpr double norm(const sequence<double>& a) { return numeric::elementary::sqrt(dot(a, a)); }

  double least_; ///< smallest remainder of an independent row, relative to the row
  sequence<sequence<double>> basis_{};
  sequence<double> right_{};
};

/// Returns for each row whether it is independent of the preceding rows in some configuration.
constexpr sequence<char> independent_rows(const sequence<numbers>& states, int rows) {
  sequence<row_space> spaces(states.size());
  sequence<char> independent;
  for (int i = 0; i < rows; ++i) {
    bool adds = states.empty(); // without states, a row counts as independent
    for (int s = 0; s < states.size(); ++s)
      if (spaces[s].add(states[s].row(i))) adds = true;
    independent.push(adds ? 1 : 0);
  }
  return independent;
}

constexpr sequence<char> independent_rows(const symbolic::matrix& a, const mechanism* of = nullptr) {
  return independent_rows(equilibrated(at_generic_states(a, of)), a.rows);
}

/// Whether the rows of a matrix are independent in some configuration, for some magnitudes of the symbols.
constexpr bool has_independent_rows(const symbolic::matrix& a, const mechanism& of) {
  if (!independent_rows(a, &of).contains(0)) return true;
  for (const double size : trial_sizes)
    for (const numbers& state : equilibrated(at_generic_states(a, &of, size))) {
      row_space space(clearly);
      bool all = true;
      for (int i = 0; i < a.rows; ++i) all = space.add(state.row(i)) && all;
      if (all) return true;
    }
  return false;
}

} // namespace kanexpr::mechanics
