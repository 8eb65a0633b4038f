#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/motion/generic_states.hpp>
#include <kanexpr/numeric/elimination.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

namespace kanexpr::mechanics {

/// Finds configurations in which all constraints hold, by the Levenberg–Marquardt method, which tolerates
/// redundant constraints. The norms of quaternions are treated as additional constraints.
class consistent_configurations {
public:
  /// The first rows of `by_q` contain the derivatives of the constraints `all`.
  constexpr consistent_configurations(const mechanism& m, const symbolic::matrix& by_q,
                                      const sequence<expression>& all)
      : m_(m), by_q_(by_q), all_(all), sizes_(*m.g), evaluate_(*m.g, outputs(by_q, all)),
        generic_(*m.g, evaluate_.live(), &m, 1.0), symbols_(m.g->size(), 0.0) {
    for (const frame& f : m.frames) {
      bool is_free = true, is_used = false;
      for (const expression& e : f.quaternion) {
        is_free = is_free && m.coordinates.contains(e);
        is_used = is_used || evaluate_.live().contains(e.node());
      }
      if (is_free && is_used) quaternions_.push(&f);
    }
  }
  consistent_configurations(const consistent_configurations&) = delete;
  consistent_configurations& operator=(const consistent_configurations&) = delete;

  /// Calls `visit` with each symbol on which the constraints depend.
  template <class Visit>
  constexpr void each_symbol(const Visit& visit) const {
    for (int id : evaluate_.live())
      if ((*m_.g)[id].op == symbolic::operation::symbol) visit(id);
    for (const frame* f : quaternions_)
      for (const expression& e : f->quaternion) visit(e.node());
  }

  /// Finds another configuration from a new random start; returns false if the iteration does not converge.
  constexpr bool next() {
    generic_.draw();
    each_symbol([&](int id) { symbols_[id] = generic_[id]; });
    row_sizes_.clear();
    if (!evaluate()) return false;
    for (int i = 0; i < rows_.rows; ++i) row_sizes_.push(length_of_row(i));
    for (const double size : row_sizes_)
      if (!(size > 0)) return false;
    if (!evaluate()) return false;
    double damping = 1e-2, last = residual();
    for (int steps = 0; steps < 40 && last > rounding; ++steps) {
      const sequence<double> before = symbols_;
      step(damping);
      if (const double now = evaluate() ? residual() : last; now < last) {
        last = now;
        damping = damping > 1e-9 ? damping / 10 : damping;
        continue;
      }
      if (last <= tolerance) break;
      symbols_ = before, damping *= 10;
      if (!evaluate()) return false;
    }
    return last <= tolerance;
  }

  /// The number of leading rows that contain the norms of quaternions. The rows of the constraints follow.
  /// Each row is divided by its length at the start of the iteration.
  constexpr int count_of_norms() const { return quaternions_.size(); }
  constexpr sequence<double> row(int i) const {
    sequence<double> entries;
    for (int j = 0; j < columns(); ++j) entries.push(rows_(i, j));
    return entries;
  }

  constexpr double length_of_constraint(int i) const { return length_of_row(count_of_norms() + i); }

  constexpr double operator[](int symbol) const { return symbols_[symbol]; }

private:
  static constexpr double tolerance = 1e-10, rounding = 1e-14;

  static constexpr sequence<int> outputs(const symbolic::matrix& by_q, const sequence<expression>& all) {
    sequence<int> nodes = symbolic::nodes_of(by_q.entries);
    for (const expression& e : all) nodes.push(e.node());
    return nodes;
  }
  constexpr int columns() const { return m_.coordinates.size(); }
  constexpr double length_of_row(int i) const {
    double square = 0;
    for (int j = 0; j < columns(); ++j) square += rows_(i, j) * rows_(i, j);
    return numeric::elementary::sqrt(square);
  }

  /// Evaluates the derivatives with respect to all coordinates, in units of the coordinates, and the
  /// residuals in the last column.
  constexpr bool evaluate() {
    evaluate_.at([&](int id) { return symbols_[id]; });
    rows_ = numbers{count_of_norms() + all_.size(), columns() + 1, {}};
    for (const frame* f : quaternions_) {
      double square = 0;
      sequence<double> row(columns(), 0.0);
      for (const expression& e : f->quaternion) {
        const double entry = symbols_[e.node()];
        row[m_.coordinates.find(e)] = entry, square += entry * entry;
      }
      for (double each : row) rows_.entries.push(each);
      rows_.entries.push((square - 1) / 2);
    }
    for (int i = 0; i < all_.size(); ++i) {
      for (int j = 0; j < columns(); ++j)
        rows_.entries.push(evaluate_[by_q_(i, j).node()] * sizes_[m_.coordinates[j].node()]);
      rows_.entries.push(evaluate_[all_[i].node()]);
    }
    for (int i = 0; i < row_sizes_.size(); ++i)
      for (int j = 0; j <= columns(); ++j) rows_.entries[i * rows_.columns + j] /= row_sizes_[i];
    return rows_.finite();
  }
  constexpr double residual() const {
    double square = 0;
    for (int i = 0; i < rows_.rows; ++i) square += rows_(i, columns()) * rows_(i, columns());
    return numeric::elementary::sqrt(square);
  }

  /// Takes the step δ of (Jᵀ J + damping) δ = −Jᵀ f.
  constexpr void step(double damping) {
    const int n = columns();
    const auto product = [&](int j, int k) {
      double sum = 0;
      for (int i = 0; i < rows_.rows; ++i) sum += rows_(i, j) * rows_(i, k);
      return sum;
    };
    const numeric::factors place{n};
    sequence<double> square(place.size(), 0), delta;
    for (int j = 0; j < n; ++j) {
      for (int k = 0; k < n; ++k) square[place.at(j, k)] = product(j, k) + (j == k ? damping : 0);
      delta.push(-product(j, n));
    }
    numeric::factorize<numeric::constant_elimination_math>(n, &square[0]);
    numeric::solve_factorized<numeric::constant_elimination_math>(n, &square[0], &delta[0]);
    for (int j = 0; j < n; ++j) {
      const int id = m_.coordinates[j].node();
      symbols_[id] += delta[j] * sizes_[id];
    }
  }

  const mechanism& m_;
  const symbolic::matrix& by_q_;
  const sequence<expression>& all_;
  symbolic::typical_sizes sizes_;
  symbolic::evaluation evaluate_;
  detail::generic_values generic_;
  sequence<double> symbols_, row_sizes_{};
  sequence<const frame*> quaternions_{};
  numbers rows_{};
};

} // namespace kanexpr::mechanics
