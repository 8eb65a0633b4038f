#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/constraints/consistent_configurations.hpp>
#include <kanexpr/mechanics/constraints/constraints.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/symbolic/derivatives/evaluate_rate.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

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
      : s_(s), m_(*s.model), by_u_(c.jacobian), sizes_(*m_.g), symbols_(m_.g->size()), has_rates_(has_rates),
        are_linear_(c.nonlinear == 0), places_(first(configurations, c.on_configuration)),
        moves_(first(velocities, c.velocity_residual())), configurations_(m_, configuration, places_),
        evaluate_(*m_.g, outputs(wanted)), rates_(*m_.g, outputs_with_rates()),
        generic_(*m_.g, evaluate_.live(), &m_, 1.0) {}

  /// Finds another state from a new random start; returns false if the iteration does not converge.
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
    return !numeric::elementary::detail::is_finite(value) ||
           numeric::elementary::abs(value) <= 1e-7 * symbolic::magnitudes(*m_.g, evaluate_)[e.node()];
  }

  /// After `next`, the first velocity constraint whose derivatives with respect to the speeds vanished while
  /// the state approached it; none if there is no such constraint.
  constexpr int row_that_vanished() const {
    for (int i = 0; i < sizes_at_start_.size(); ++i)
      if (size_of_row(i) < 1e-6 * sizes_at_start_[i]) return i;
    return none;
  }

  /// After `next`, the first velocity constraint whose derivatives with respect to the speeds became a
  /// combination of those of the preceding ones while the state approached it.
  constexpr int row_that_became_dependent() const {
    const sequence<double> now = independent_parts();
    for (int i = 1; i < parts_at_start_.size(); ++i)
      if (now[i] < 1e-4 * parts_at_start_[i] && now[i] < 1e-5) return i;
    return none;
  }

private:
  static constexpr sequence<expression> first(int count, const sequence<expression>& all) {
    sequence<expression> some;
    for (int i = 0; i < count; ++i) some.push(all[i]);
    return some;
  }
  constexpr sequence<int> outputs(const sequence<expression>& wanted) const {
    sequence<expression> all;
    if (!moves_.empty()) all.append(moves_), all.append(by_u_.entries);
    if (has_rates_) all.append(s_.coordinate_rates);
    all.append(wanted);
    return symbolic::nodes_of(all);
  }

  constexpr sequence<int> outputs_with_rates() const {
    if (has_rates_) return symbolic::nodes_of(moves_);
    return {};
  }

  constexpr void evaluate() {
    evaluate_.at([&](int id) { return symbols_[id].value; });
  }
  constexpr double value(expression e) const { return evaluate_[e.node()]; }

  constexpr bool place() {
    if (!places_.empty()) {
      if (!configurations_.next()) return false;
      configurations_.each_symbol([&](int id) { symbols_[id] = {configurations_[id], 0}; });
    }
    evaluate();
    return true;
  }

  constexpr bool move() {
    if (moves_.empty()) return true;
    constexpr int most_steps = 30; // for a double root, each step halves the distance
    sizes_at_start_.clear(), parts_at_start_.clear();
    if (!are_linear_) parts_at_start_ = independent_parts();
    for (int i = 0; i < moves_.size() && !are_linear_; ++i) sizes_at_start_.push(size_of_row(i));
    for (int steps = 0; steps < most_steps; ++steps) {
      sequence<double> residual;
      for (const expression& v : moves_) residual.push(value(v));
      if (!change(m_.speeds, residual)) return false;
      evaluate();
      if (are_linear_ || speeds_satisfy()) return true;
    }
    return false;
  }

  /// The largest derivative of a velocity constraint with respect to a speed, in units of the speed.
  constexpr double size_of_row(int i) const {
    double largest = 0;
    for (int j = 0; j < by_u_.columns; ++j) {
      const double entry = numeric::elementary::abs(value(by_u_(i, j))) * sizes_[m_.speeds[j].node()];
      if (entry > largest) largest = entry;
    }
    return largest;
  }

  /// The derivatives of a velocity constraint with respect to the speeds, in units of the speeds.
  constexpr sequence<double> row_of(int i) const {
    sequence<double> row;
    for (int j = 0; j < by_u_.columns; ++j) row.push(value(by_u_(i, j)) * sizes_[m_.speeds[j].node()]);
    return row;
  }

  /// For each velocity constraint, the part of its derivatives that those of the preceding ones do not
  /// contain, relative to all of them.
  constexpr sequence<double> independent_parts() const {
    const auto product = [](const sequence<double>& a, const sequence<double>& b) {
      double sum = 0;
      for (int j = 0; j < a.size(); ++j) sum += a[j] * b[j];
      return sum;
    };
    sequence<sequence<double>> basis;
    sequence<double> parts;
    for (int i = 0; i < moves_.size(); ++i) {
      sequence<double> row = row_of(i);
      const double whole = product(row, row);
      if (!(whole > 0) || !numeric::elementary::detail::is_finite(whole)) {
        parts.push(0);
        continue;
      }
      for (const sequence<double>& each : basis) {
        const double along = product(each, row);
        for (int j = 0; j < row.size(); ++j) row[j] -= along * each[j];
      }
      const double rest = product(row, row);
      parts.push(rest > 0 ? numeric::elementary::sqrt(rest / whole) : 0.0);
      if (!(rest > 0)) continue;
      const double length = numeric::elementary::sqrt(rest);
      for (double& entry : row) entry /= length;
      basis.push(row);
    }
    return parts;
  }

  /// Whether the velocity constraints hold up to rounding.
  constexpr bool speeds_satisfy() const {
    const symbolic::magnitudes terms(*m_.g, evaluate_);
    for (const expression& v : moves_)
      if (!(numeric::elementary::abs(value(v)) <= 1e-12 * terms[v.node()])) return false;
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
      sequence<double> residual;
      for (const expression& v : moves_) residual.push(rates_[v.node()].rate);
      if (!change(m_.speed_rates, residual)) return false;
    }
    evaluate();
    return true;
  }

  /// Changes the unknowns as little as possible, in units of their typical sizes, so that the residual of
  /// J u + c = 0, or of its rate, vanishes. Returns false if the rows are singular. Zero rows are skipped.
  constexpr bool change(const sequence<expression>& unknowns, const sequence<double>& residual) {
    const int n = unknowns.size();
    row_space equations;
    for (int i = 0; i < residual.size(); ++i) {
      numbers row{1, n, {}};
      bool is_zero = true;
      for (int j = 0; j < n; ++j) {
        row.entries.push(value(by_u_(i, j)) * sizes_[unknowns[j].node()]);
        is_zero = is_zero && base::equal(row.entries[j], 0.0);
      }
      if (!row.finite() || !numeric::elementary::detail::is_finite(residual[i])) return false;
      if (!is_zero && !equations.add(row.entries, -residual[i])) return false;
    }
    const sequence<double> changes = equations.solution(n);
    for (int j = 0; j < n; ++j) {
      const int id = unknowns[j].node();
      symbols_[id].value += changes[j] * sizes_[id];
    }
    return true;
  }

  const skeleton& s_;
  const mechanism& m_;
  const symbolic::matrix& by_u_;
  symbolic::typical_sizes sizes_;
  sequence<symbolic::value_and_rate> symbols_;
  bool has_rates_, are_linear_;
  sequence<expression> places_, moves_;
  consistent_configurations configurations_;
  symbolic::evaluation evaluate_;
  symbolic::rate_evaluation rates_;
  detail::generic_values generic_;
  sequence<double> sizes_at_start_{}, parts_at_start_{}; ///< of the rows of nonlinear constraints
};

/// The number of states to check, the number of attempts to find them, and the number that must be found.
struct sampling {
  int attempts = 12;
  int states = 3;
  int least = 2;
};

/// Returns the first expression that does not vanish at any of the states found, or none.
constexpr int first_that_never_vanishes(consistent_states& states, const sequence<expression>& wanted,
                                        const sampling& at = {}) {
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
