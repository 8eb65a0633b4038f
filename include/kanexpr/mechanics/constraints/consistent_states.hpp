#pragma once

#include <kanexpr/mechanics/constraints/constraints.hpp>
#include <kanexpr/symbolic/derivatives/evaluate_rate.hpp>

namespace kanexpr::mechanics {

/// Random states, with rates of the speeds, that satisfy the constraints. They are used to test numerically
/// whether an expression vanishes wherever the constraints hold.
class consistent_states {
public:
  /// Uses the first `configurations` configuration constraints, with their derivatives, and the first
  /// `velocities` velocity constraints. `wanted` are the expressions to evaluate; they may contain rates of
  /// coordinates and speeds if `has_rates`.
  constexpr consistent_states(const skeleton& s, const symbolic::matrix& configuration, int configurations,
                              const constraints& c, int velocities, const sequence<expression>& wanted,
                              bool has_rates = false)
      : s_(s), m_(*s.model), by_q_(configuration), by_u_(c.jacobian), sizes_(*m_.g), symbols_(m_.g->size()),
        has_rates_(has_rates), places_(first(configurations, c.on_configuration)),
        moves_(first(velocities, values_of(c))), evaluate_(*m_.g, outputs(wanted)),
        rates_(*m_.g, outputs_with_rates()), generic_(*m_.g, evaluate_.live(), &m_, 1.0) {}

  /// Finds a state from a new random start; returns false if the iteration does not converge.
  constexpr bool next() {
    generic_.draw();
    for (int id : evaluate_.live())
      if ((*m_.g)[id].op == symbolic::operation::symbol) symbols_[id] = {generic_[id], 0};
    for (const sequence<expression>* all : {&m_.auxiliary_speeds, &m_.speed_rates, &m_.coordinate_rates})
      for (const expression& e : *all) symbols_[e.node()] = {};
    return place() && move() && (!has_rates_ || accelerate());
  }

  /// Whether an expression vanishes relative to its terms.
  constexpr bool vanishes(expression e) const {
    const double value = evaluate_[e.node()];
    return !elementary::detail::is_finite(value) ||
           elementary::abs(value) <= 1e-7 * symbolic::magnitudes(*m_.g, evaluate_)[e.node()];
  }

private:
  static constexpr sequence<expression> first(int count, const sequence<expression>& all) {
    sequence<expression> some;
    for (int i = 0; i < count; ++i) some.push(all[i]);
    return some;
  }
  static constexpr sequence<expression> values_of(const constraints& c) {
    sequence<expression> values;
    for (const velocity_constraint& v : c.on_velocities) values.push(v.value);
    return values;
  }
  constexpr sequence<int> outputs(const sequence<expression>& wanted) const {
    sequence<int> nodes;
    const auto add = [&](const sequence<expression>& all) {
      for (const expression& e : all) nodes.push(e.node());
    };
    if (!places_.empty()) add(places_), add(by_q_.entries);
    if (!moves_.empty()) add(moves_), add(by_u_.entries);
    if (has_rates_) add(s_.coordinate_rates);
    add(wanted);
    return nodes;
  }

  constexpr sequence<int> outputs_with_rates() const {
    if (has_rates_) return symbolic::nodes_of(moves_);
    return {};
  }

  constexpr void evaluate() {
    evaluate_.at([&](int id) { return symbols_[id].value; });
  }
  constexpr double value(expression e) const { return evaluate_[e.node()]; }

  /// Finds a configuration by Newton's method from a random start.
  constexpr bool place() {
    evaluate();
    if (places_.empty()) return true;
    double step = 1;
    for (int steps = 0; steps < 40 && step > 1e-12; ++steps) {
      numbers rows{places_.size(), m_.coordinates.size() + 1, {}};
      for (int i = 0; i < rows.rows; ++i) {
        for (int j = 0; j < m_.coordinates.size(); ++j) rows.entries.push(value(by_q_(i, j)));
        rows.entries.push(value(places_[i]));
      }
      keep_norms(rows);
      step = change(rows, m_.coordinates);
      normalize();
      evaluate();
    }
    if (!(step >= 0 && step <= 1e-12)) return false;
    for (const expression& f : places_)
      if (!elementary::detail::is_finite(value(f)) || !vanishes(f)) return false;
    return true;
  }

  constexpr bool move() {
    if (moves_.empty()) return true;
    numbers rows{moves_.size(), m_.speeds.size() + 1, {}};
    for (int i = 0; i < rows.rows; ++i) {
      for (int j = 0; j < m_.speeds.size(); ++j) rows.entries.push(value(by_u_(i, j)));
      rows.entries.push(value(moves_[i]));
    }
    if (change(rows, m_.speeds) < 0) return false;
    evaluate();
    return true;
  }

  constexpr bool accelerate() {
    for (int i = 0; i < m_.coordinates.size(); ++i) {
      const double rate = value(s_.coordinate_rates[i]);
      symbols_[m_.coordinates[i].node()].rate = rate;
      symbols_[m_.coordinate_rates[i].node()].value = rate;
    }
    symbols_[m_.time.node()].rate = 1;
    for (const prescribed_rate& p : m_.prescribed_rates)
      symbols_[p.quantity.node()].rate = symbols_[p.rate.node()].value;
    if (!moves_.empty()) {
      rates_.at([&](int id) { return symbols_[id]; });
      numbers rows{moves_.size(), m_.speeds.size() + 1, {}};
      for (int i = 0; i < rows.rows; ++i) {
        for (int j = 0; j < m_.speeds.size(); ++j) rows.entries.push(value(by_u_(i, j)));
        rows.entries.push(rates_[moves_[i].node()].rate);
      }
      if (change(rows, m_.speed_rates) < 0) return false;
    }
    evaluate();
    return true;
  }

  /// Whether an entry of a frame's quaternion is itself a coordinate.
  constexpr bool is_free(expression entry) const { return m_.coordinates.contains(entry); }

  /// Restricts the equations to changes that preserve the norms of quaternions.
  constexpr void keep_norms(numbers& rows) const {
    for (const frame& f : m_.frames)
      for (int i = 0; i < rows.rows && !f.quaternion.empty(); ++i) {
        const auto entry = [&](expression e) -> double& {
          return rows.entries[i * rows.columns + m_.coordinates.find(e)];
        };
        double along = 0;
        for (const expression& e : f.quaternion)
          if (is_free(e)) along += entry(e) * symbols_[e.node()].value;
        for (const expression& e : f.quaternion)
          if (is_free(e)) {
            const double before = entry(e), left = before - along * symbols_[e.node()].value;
            entry(e) = elementary::abs(left) > 1e-12 * elementary::abs(before) ? left : 0;
          }
      }
  }
  constexpr void normalize() {
    for (const frame& f : m_.frames) {
      double square = 0;
      for (const expression& e : f.quaternion)
        if (is_free(e)) square += symbols_[e.node()].value * symbols_[e.node()].value;
      if (!(square > 0)) continue;
      for (const expression& e : f.quaternion)
        if (is_free(e)) symbols_[e.node()].value /= elementary::sqrt(square);
    }
  }

  /// Solves for changes of as many unknowns as there are rows, so that the last column of the rows vanishes,
  /// by elimination with full pivoting. Returns the largest change relative to the typical sizes, or −1 if
  /// the rows are singular. Zero rows are skipped.
  constexpr double change(numbers rows, const sequence<expression>& unknowns) {
    const int n = unknowns.size();
    const auto at = [&](int i, int j) -> double& { return rows.entries[i * rows.columns + j]; };
    if (!rows.finite()) return -1;
    sequence<double> whole;
    for (int i = 0; i < rows.rows; ++i) {
      whole.push(0.0);
      for (int j = 0; j < n; ++j) {
        at(i, j) *= sizes_[unknowns[j].node()];
        if (elementary::abs(at(i, j)) > whole[i]) whole[i] = elementary::abs(at(i, j));
      }
    }
    sequence<int> pivot_of(rows.rows, none);
    for (int step = 0; step < rows.rows; ++step) {
      int row = none, column = none;
      double most = 1e-9;
      for (int i = 0; i < rows.rows; ++i)
        for (int j = 0; j < n && pivot_of[i] == none; ++j)
          if (const double size = elementary::abs(at(i, j)); size > most * whole[i])
            row = i, column = j, most = size / whole[i];
      if (row == none) break;
      pivot_of[row] = column;
      for (int i = 0; i < rows.rows; ++i) {
        if (i == row || numeric::equal(at(i, column), 0.0)) continue;
        const double factor = at(i, column) / at(row, column);
        for (int j = 0; j <= n; ++j) at(i, j) -= factor * at(row, j);
        at(i, column) = 0;
      }
    }
    double largest = 0;
    for (int i = 0; i < rows.rows; ++i) {
      if (pivot_of[i] == none) {
        if (whole[i] > 0) return -1;
        continue;
      }
      const double by = -at(i, n) / at(i, pivot_of[i]);
      const int id = unknowns[pivot_of[i]].node();
      symbols_[id].value += by * sizes_[id];
      if (elementary::abs(by) > largest) largest = elementary::abs(by);
    }
    return largest;
  }

  const skeleton& s_;
  const mechanism& m_;
  const symbolic::matrix &by_q_, &by_u_;
  symbolic::typical_sizes sizes_;
  sequence<symbolic::rated> symbols_;
  bool has_rates_;
  sequence<expression> places_, moves_;
  symbolic::evaluation evaluate_;
  symbolic::rate_evaluation rates_;
  detail::generic_values generic_;
};

/// The number of states to check, the maximum number of attempts to find them, and the number that must be
/// found.
struct looks {
  int attempts = 12;
  int states = 3;
  int least = 2;
};

/// Returns the first expression that does not vanish at any of the states found, or none.
constexpr int first_that_never_vanishes(consistent_states& states, const sequence<expression>& wanted,
                                        const looks& at = {}) {
  sequence<char> vanishes(wanted.size(), 0);
  int looked = 0;
  for (int attempts = 0; attempts < at.attempts && looked < at.states && vanishes.contains(0); ++attempts) {
    if (!states.next()) continue;
    ++looked;
    for (int i = 0; i < wanted.size(); ++i)
      if (vanishes[i] == 0 && states.vanishes(wanted[i])) vanishes[i] = 1;
  }
  return vanishes.contains(0) && looked < at.least ? none : vanishes.find(0);
}

} // namespace kanexpr::mechanics
