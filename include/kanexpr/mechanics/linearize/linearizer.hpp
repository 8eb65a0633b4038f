#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/constraints/dependent_speeds.hpp>
#include <kanexpr/mechanics/linearize/combined_rates.hpp>
#include <kanexpr/mechanics/linearize/linearization.hpp>
#include <kanexpr/mechanics/linearize/mass_columns.hpp>
#include <kanexpr/mechanics/linearize/variations.hpp>
#include <kanexpr/symbolic/cost.hpp>
#include <kanexpr/symbolic/derivatives/accumulate.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>
#include <kanexpr/symbolic/derivatives/jacobian.hpp>
#include <kanexpr/symbolic/derivatives/jacobian_modes.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/factoring.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/live_nodes.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>
#include <kanexpr/symbolic/linear/solve.hpp>

namespace kanexpr::mechanics {

/// Linearizes a general form about any point that satisfies it or, in free directions, about any point at
/// which the rates and multipliers satisfy all equations except f_c and f_v. The columns of results are those
/// of `variations`. Each result is formed on first use and only once. Results contain the symbols q, u and r,
/// and q̇, u̇ and λ if they depend on them.
class linearizer {
public:
  constexpr linearizer(graph& g, const general_form& form, directions which = directions::along_constraints)
      : g_(g), form_(form), variations_(g, form_, which) {}
  /// Creates an empty object to be restored from stored members.
  constexpr explicit linearizer(graph& g) : g_(g), variations_(g, form_) {}
  linearizer(const linearizer&) = delete;
  linearizer& operator=(const linearizer&) = delete;

  /// The stored members.
  template <class Self, class Visit>
  static constexpr void each_member(Self& self, Visit&& visit) {
    visit(self.form_, self.variations_, self.implicit_, self.explicit_, self.rates_, self.pivots_);
  }

  constexpr const general_form& form() const { return form_; }
  constexpr const mechanics::variations& variations() const { return variations_; }
  /// The pivots of the mass matrix, possibly with duplicates.
  constexpr const sequence<symbolic::pivot>& pivots() const { return pivots_; }

  /// ∂f_a/∂u̇_d.
  constexpr symbolic::matrix on_dependent() const {
    return detail::columns_of(g_, form_.known.on_udot, form_.speeds.dependent);
  }

  /// Adds the pivots of other solutions with the mass matrix.
  constexpr void add_pivots(const sequence<symbolic::pivot>& more) { pivots_.append(more); }

  constexpr const implicit_linearization& implicit_form() {
    if (implicit_.mass.rows != 0) return implicit_;
    const sequence<expression> groups[]{summed(form_.f_0, form_.f_1), form_.f_a,
                                        summed(summed(form_.f_2, form_.f_3), form_.f_4)};
    sequence<expression> zero, unknowns = form_.qdot;
    for (const sequence<expression>& group : groups) zero.append(group);
    unknowns.append(form_.udot), unknowns.append(form_.lambda);
    // treats each group separately, because the cheaper method may differ between groups
    explicit_linearization change(g_, zero.size(), variations_.states(), form_.inputs());
    int row = 0;
    for (const sequence<expression>& group : groups) {
      const explicit_linearization rows = along_all(group);
      for (int i = 0; i < group.size(); ++i, ++row)
        for (int j = 0; j < variations_.size(); ++j) change(row, j) = rows(i, j);
    }
    implicit_ = {symbolic::forward_jacobian(g_, zero, unknowns), change.state, change.input};
    for (expression& e : implicit_.state.entries) e = -e;
    for (expression& e : implicit_.input.entries) e = -e;
    return implicit_;
  }

  /// δ[q̇_i; u̇_i] of the independent coordinates and speeds.
  constexpr const explicit_linearization& explicit_form() {
    if (explicit_.state.rows != 0) return explicit_;
    if (!is_reduced()) return explicit_ = rows_of_states(g_, form_, solved_rates());
    sequence<expression> rates;
    for (int i : form_.coordinates.independent) rates.push(form_.known.qdot[i]);
    const explicit_linearization above = along_all(rates);
    const symbolic::matrix below = accelerations();
    explicit_ = explicit_linearization(g_, form_.states(), variations_.states(), form_.inputs());
    for (int i = 0; i < form_.states(); ++i)
      for (int j = 0; j < variations_.size(); ++j)
        explicit_(i, j) = i < rates.size() ? above(i, j) : below(i - rates.size(), j);
    return explicit_;
  }

  /// δ[q̇; u̇] of all coordinates and speeds.
  constexpr explicit_linearization of_all_rates() {
    sequence<int> rows;
    for (int i = 0; i < form_.q.size() + form_.u.size(); ++i) rows.push(i);
    return rows_of(g_, rates(), rows, form_.inputs());
  }

  /// δf in M (δu̇_i − δe) = δf for each direction, without multipliers, where δe are the `direct_changes`.
  constexpr const symbolic::matrix& changes_of_force() {
    if (force_.rows == 0) force_ = cheapest_changes(force_with_direct_changes());
    return force_;
  }

  /// The same by forward differentiation, which shares its steps with derivatives of second order.
  constexpr const symbolic::matrix& changes_of_force_by_forward() {
    if (force_by_forward_.rows == 0) force_by_forward_ = changes_by_forward(force_with_direct_changes());
    return force_by_forward_;
  }

  /// The part of δu̇_i that requires no solution, as the change of gravity in the axes of a free body.
  constexpr const symbolic::matrix& direct_changes() {
    force_with_direct_changes();
    return direct_;
  }

  /// δb in δu̇_d = A δu̇_i + δb for each direction.
  constexpr const symbolic::matrix& changes_of_bias() {
    if (bias_.rows == 0) bias_ = acceleration_bias();
    return bias_;
  }

  /// C and D of outputs that may contain q, u, r, q̇ and u̇.
  constexpr explicit_linearization outputs(const sequence<expression>& y) {
    explicit_linearization out = along_all(y);
    const symbolic::matrix by_qdot = symbolic::forward_jacobian(g_, y, form_.qdot),
                           by_udot = symbolic::forward_jacobian(g_, y, form_.udot);
    if (is_zero(by_qdot) && is_zero(by_udot)) return out;
    const symbolic::matrix& known = rates();
    for (int i = 0; i < y.size(); ++i)
      for (int j = 0; j < variations_.size(); ++j) {
        for (int k = 0; k < by_qdot.columns; ++k) out(i, j) += by_qdot(i, k) * known(k, j);
        for (int k = 0; k < by_udot.columns; ++k) out(i, j) += by_udot(i, k) * known(by_qdot.columns + k, j);
      }
    return out;
  }

private:
  /// Whether the dynamics are those for the independent speeds, with a known symmetric mass matrix.
  constexpr bool is_reduced() const { return form_.lambda.empty() && form_.known.mass.rows != 0; }

  /// For each expression in `of`, adds a weighted sum of `more` and passes the derivatives along all
  /// directions to `take`. `weights` has a column for each expression. Each expression takes one reverse
  /// pass. (Defined before its callers, because clang++ instantiates it there.)
  template <class Take>
  constexpr void for_each_gradient(const sequence<expression>& of, const sequence<expression>& more,
                                   const symbolic::matrix& weights, const sequence<combined_rate>& held,
                                   const Take& take) const {
    sequence<expression> all = of;
    all.append(more);
    symbolic::accumulation back(g_, all);
    for (const combined_rate& each : held) back.hold(each.sum);
    for (int i = 0; i < of.size(); ++i) {
      back.restart();
      back.seed(of[i], {g_, graph::one});
      for (int d = 0; d < weights.rows; ++d) back.seed(more[d], weights(d, i));
      back.run();
      for (int j = 0; j < variations_.size(); ++j)
        take(i, j, variations_.contracted(j, [&](expression symbol) { return back.by(symbol); }));
    }
  }

  /// Uses one forward pass for each direction, or one reverse pass for each expression if these are fewer and
  /// no direction moves a dependent variable.
  constexpr explicit_linearization along_all(const sequence<expression>& of) const {
    explicit_linearization out(g_, of.size(), variations_.states(), form_.inputs());
    if (has_no_dependents() && of.size() < active_directions(of)) {
      for_each_gradient(of, {}, {}, {}, [&](int i, int j, expression slope) { out(i, j) = slope; });
      return out;
    }
    if (of.empty()) return out;
    const symbolic::dependence found = variations_.dependence_of(of);
    for (int j = 0; j < variations_.size(); ++j) {
      symbolic::differentiation d = variations_.along(j);
      d.skip_unchanged(found, j);
      for (int i = 0; i < of.size(); ++i) out(i, j) = d.of(of[i]);
    }
    return out;
  }

  /// δ[q̇; u̇] for each direction, followed by δλ if it is known.
  constexpr const symbolic::matrix& rates() { return is_reduced() ? all_rates() : solved_rates(); }

  /// δ[q̇; u̇; λ] for each direction, from the implicit form.
  constexpr const symbolic::matrix& solved_rates() {
    if (rates_.rows == 0) rates_ = solve_for_rates(g_, implicit_form()).x;
    return rates_;
  }

  /// δ[q̇; u̇] for each direction, from the explicit form.
  constexpr const symbolic::matrix& all_rates() {
    if (rates_.rows != 0) return rates_;
    const int n = form_.q.size(), first = form_.coordinates.independent.size();
    sequence<expression> dependent;
    for (int i : form_.coordinates.dependent) dependent.push(form_.known.qdot[i]);
    const explicit_linearization of_dependent = along_all(dependent), &of_states = explicit_form();
    const symbolic::matrix bias = acceleration_bias();
    rates_ = symbolic::matrix(g_, n + form_.u.size(), variations_.size());
    for (int j = 0; j < rates_.columns; ++j) {
      for (int i = 0; i < first; ++i) rates_(form_.coordinates.independent[i], j) = of_states(i, j);
      for (int i = 0; i < dependent.size(); ++i)
        rates_(form_.coordinates.dependent[i], j) = of_dependent(i, j);
      for (int i = 0; i < form_.speeds.independent.size(); ++i)
        rates_(n + form_.speeds.independent[i], j) = of_states(first + i, j);
      for (int d = 0; d < bias.rows; ++d) {
        expression& rate = rates_(n + form_.speeds.dependent[d], j) = bias(d, j);
        for (int i = 0; i < form_.speeds.independent.size(); ++i)
          rate += form_.known.dependency(d, i) * of_states(first + i, j);
      }
    }
    return rates_;
  }

  /// δu̇_i for each direction. With Φ = f_2 + f_3 and μ from (∂f_a/∂u̇_d)ᵀ μ = coupling, the mass matrix
  /// times δu̇_i is the derivative of μᵀ f_a − Φ at constant u̇ and μ: the solution for u̇ is never
  /// differentiated.
  constexpr symbolic::matrix accelerations() {
    const symbolic::matrix change = factored_changes();
    mass_columns mass(g_, form_.known.mass);
    symbolic::matrix out = mass.solve(change);
    add_pivots(mass.pivots());
    for (int i = 0; i < direct_.rows; ++i)
      for (int j = 0; j < direct_.columns; ++j) out(i, j) += direct_(i, j);
    return out;
  }

  /// The changes of the force with common parts taken out. With constraints, the other results have most of
  /// these parts in common with them.
  constexpr symbolic::matrix factored_changes() {
    constexpr int most_operations = 3000, most_passes = 1;
    const symbolic::matrix& change = changes_of_force();
    if (!form_.f_a.empty() || !has_no_dependents() || is_zero(change)) return change;
    return symbolic::factored(g_, change, form_.known.mass, most_operations, most_passes);
  }

  /// −(f_2 + f_3). Separates the sums in which rates are combined with other terms, and the changes of the
  /// rates that cancel the changes of these terms.
  constexpr sequence<expression> force_with_direct_changes() {
    const sequence<expression> force = negative(summed(form_.f_2, form_.f_3));
    if (!form_.f_a.empty() || direct_.rows != 0) return force;
    combined_ = combined_rates(force, form_.udot);
    sequence<expression> sums;
    for (const combined_rate& each : combined_) sums.push(each.sum);
    const explicit_linearization change = along_all(sums);
    direct_ = symbolic::matrix(g_, force.size(), variations_.size());
    for (int k = 0; k < combined_.size(); ++k)
      for (int j = 0; j < direct_.columns; ++j)
        direct_(combined_[k].speed, j) = combined_[k].is_negative ? change(k, j) : -change(k, j);
    return force;
  }

  /// The changes of the force in the form with the fewest operations.
  constexpr symbolic::matrix cheapest_changes(const sequence<expression>& force) {
    if (!form_.f_a.empty() || !has_no_dependents()) {
      sequence<expression> all = force;
      all.append(form_.f_a);
      if (force.size() < active_directions(all)) return changes_by_reverse(force);
      return changes_by_forward(force);
    }
    sequence<expression> states, held;
    for (int j = 0; j < variations_.states(); ++j) states.push(variations_.symbol(j));
    for (const combined_rate& each : combined_) held.push(each.sum);
    const symbolic::jacobian_modes modes(g_, symbolic::nodes_of(force), states, held);
    if (modes.by_forward() < modes.by_both()) return changes_by_forward(force);
    symbolic::matrix out = changes_by_reverse(force);
    const auto operations = [&](const symbolic::matrix& m) {
      const symbolic::cost c = symbolic::cost_of(g_, symbolic::nodes_of(m.entries));
      return c.multiplications + c.additions;
    };
    // the estimate does not include shared results, of which forward differentiation has more; both are
    // formed only where this takes little of a compiler's time and memory
    constexpr int most_formed_twice = 30000;
    if (modes.by_forward() < most_formed_twice && 10 * modes.by_forward() < 11 * modes.by_both())
      if (const symbolic::matrix other = changes_by_forward(force); operations(other) < operations(out))
        return other;
    for (int j = 0; j < states.size(); ++j) {
      if (!modes.is_forward(j)) continue;
      symbolic::differentiation d = along_without_sums(j);
      for (int i = 0; i < out.rows; ++i) out(i, j) = d.of(force[i]);
    }
    return out;
  }

  /// The derivatives along a direction, with the sums in which rates are combined held constant.
  constexpr symbolic::differentiation along_without_sums(int j) const {
    symbolic::differentiation d = variations_.along(j);
    for (const combined_rate& each : combined_) d.set_rate(each.sum, {g_, graph::zero});
    return d;
  }

  constexpr bool has_no_dependents() const {
    return variations_.of_coordinates().rows == 0 && variations_.of_speeds().rows == 0;
  }

  /// The number of state directions on which the expressions `of` depend.
  constexpr int active_directions(const sequence<expression>& of) const {
    const base::zeros<char> live = symbolic::live_nodes(g_, symbolic::nodes_of(of));
    const auto is_live = [&](expression symbol) -> expression {
      return {g_, live[symbol.node()] != 0 ? graph::one : graph::zero};
    };
    int felt = 0;
    for (int j = 0; j < variations_.states(); ++j)
      if (!variations_.contracted(j, is_live).is_zero()) ++felt;
    return felt;
  }

  constexpr symbolic::matrix changes_by_reverse(const sequence<expression>& force) {
    symbolic::matrix out(g_, force.size(), variations_.size());
    for_each_gradient(force, form_.f_a, constraint_weights(), combined_,
                      [&](int i, int j, expression slope) { out(i, j) = slope; });
    return out;
  }

  constexpr symbolic::matrix changes_by_forward(const sequence<expression>& force) {
    const symbolic::matrix bias = acceleration_bias();
    symbolic::matrix out(g_, force.size(), variations_.size());
    const symbolic::dependence found = variations_.dependence_of(force);
    for (int j = 0; j < out.columns; ++j) {
      symbolic::differentiation d = along_without_sums(j);
      d.skip_unchanged(found, j);
      for (int i = 0; i < out.rows; ++i) {
        out(i, j) = d.of(force[i]);
        for (int k = 0; k < bias.rows; ++k) out(i, j) -= form_.known.coupling(k, i) * bias(k, j);
      }
    }
    return out;
  }

  /// μ, a column for each independent speed.
  constexpr symbolic::matrix constraint_weights() {
    return symbolic::solve_linear(g_, transposed(g_, on_dependent()), form_.known.coupling).x;
  }

  /// The part of δu̇_d from f_a = 0 that does not depend on δu̇_i, a column for each direction.
  constexpr symbolic::matrix acceleration_bias() {
    const explicit_linearization change = along_all(form_.f_a);
    symbolic::matrix right(g_, form_.f_a.size(), variations_.size());
    for (int i = 0; i < right.rows; ++i)
      for (int j = 0; j < right.columns; ++j) right(i, j) = -change(i, j);
    return symbolic::solve_linear(g_, on_dependent(), right).x;
  }

  graph& g_;
  general_form form_{};
  mechanics::variations variations_;
  implicit_linearization implicit_{};
  explicit_linearization explicit_{};
  symbolic::matrix rates_{};
  symbolic::matrix force_{}, force_by_forward_{}, direct_{},
      bias_{}; ///< changes; formed again after a restore
  sequence<combined_rate> combined_{};
  sequence<symbolic::pivot> pivots_{};
};

} // namespace kanexpr::mechanics
