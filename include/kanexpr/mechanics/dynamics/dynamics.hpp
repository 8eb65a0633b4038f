#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/constraints/acceleration_constraints.hpp>
#include <kanexpr/mechanics/dynamics/absolute_speeds.hpp>
#include <kanexpr/mechanics/dynamics/articulated_bodies.hpp>
#include <kanexpr/mechanics/dynamics/gathered.hpp>
#include <kanexpr/mechanics/dynamics/kane.hpp>
#include <kanexpr/mechanics/dynamics/lagrange.hpp>
#include <kanexpr/mechanics/dynamics/mass_and_force.hpp>
#include <kanexpr/mechanics/dynamics/reactions.hpp>
#include <kanexpr/mechanics/dynamics/solution_cost.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/linear/cofactors.hpp>
#include <kanexpr/symbolic/linear/solve.hpp>

#include <utility>

namespace kanexpr::mechanics {

/// The equations of motion of a system with or without constraints, by Kane's or Lagrange's method, and
/// quantities derived from them. Each is formed on first use and only once.
class dynamics {
public:
  constexpr dynamics(const skeleton& s, const loads& acting, const constraints& c, const partition& speeds)
      : s_(s), m_(*s.model), loads_(acting), constraints_(c), speeds_(speeds) {}

  /// The stored members.
  template <class Self, class Visit>
  static constexpr void each_member(Self& self, Visit&& visit) {
    visit(self.lagrange_, self.has_dependent_, self.has_coupling_, self.has_lambda_, self.has_other_form_,
          self.bias_, self.dependent_, self.free_mass_, self.coupling_, self.mass_, self.lambda_,
          self.free_force_, self.force_, self.udot_, self.udot_by_elimination_, self.pivots_);
  }

  constexpr bool has_dependent() const { return has_dependent_; }

  /// γ in J u̇ + γ = 0.
  constexpr const sequence<expression>& constraint_bias() {
    if (bias_.empty()) bias_ = bias_of(constraints_);
    return bias_;
  }
  constexpr sequence<expression> bias_of(const constraints& any) const {
    sequence<expression> bias;
    motion k = motion_on_accelerated_ground(s_, loads_);
    for (int i = 0; i < any.size(); ++i) bias.push(rate_of_constraint(k, any, i));
    return bias;
  }

  /// The dependent speeds and their rates in terms of the independent ones.
  constexpr const dependent_speeds& dependent() {
    if (has_dependent_) return dependent_;
    const sequence<expression>& bias = constraint_bias();
    dependent_ = solve_for_dependent_speeds(m_, constraints_, speeds_, bias);
    if (!constraints_.on_accelerations.empty()) take_acceleration_constraints();
    has_dependent_ = true;
    return dependent_;
  }

  /// The dependent speeds from the constraints; after one Newton step if a constraint is not linear.
  constexpr sequence<expression> speeds_by_constraints() {
    if (constraints_.nonlinear != 0) {
      sequence<expression> next = dependent().at_rest;
      for (int d = 0; d < next.size(); ++d) next[d] += m_.speeds[speeds_.dependent[d]];
      return next;
    }
    sequence<expression> independent;
    for (const int i : speeds_.independent) independent.push(m_.speeds[i]);
    return solved_for_dependent(dependent().on_independent, independent, dependent().at_rest);
  }

  /// For each dependent speed, the determinant of the block that is solved for it. The determinant is 0 where
  /// the block is singular and changes sign there.
  constexpr sequence<expression> constraint_pivots() {
    sequence<expression> pivots(speeds_.dependent.size(), m_.one());
    for (const symbolic::solved_block& b : dependent().blocks) {
      sequence<expression> entries;
      for (int i : b.rows)
        for (int d : b.columns) entries.push(constraints_.jacobian(i, speeds_.dependent[d]));
      const int order = b.rows.size();
      const expression pivot = order <= symbolic::largest_with_determinant
                                   ? symbolic::determinant(entries, order)
                                   : b.measure; // this measure has no sign
      for (int d : b.columns) pivots[d] = pivot;
    }
    return pivots;
  }

  /// B = M_di + M_dd A.
  constexpr const symbolic::matrix& coupling() {
    if (has_coupling_ || speeds_.dependent.empty()) return coupling_;
    const symbolic::matrix& mass = free_mass();
    coupling_ = mechanics::coupling(*m_.g, mass, speeds_, dependent().on_independent);
    has_coupling_ = true;
    return coupling_;
  }

  /// M for the independent speeds.
  constexpr const symbolic::matrix& mass() {
    if (mass_.rows != 0) return mass_;
    const symbolic::matrix &free = free_mass(), &on_independent = dependent().on_independent;
    mass_ = reduced_mass(*m_.g, free, speeds_, on_independent, coupling());
    if (force_.empty()) force_ = formed_force();
    shorten_mass_and_force();
    return mass_;
  }

  /// f in M u̇ = f for the independent speeds.
  constexpr const sequence<expression>& force() {
    if (force_.empty() && is_too_long()) force_ = formed_force();
    if (force_.empty()) mass();
    return force_;
  }

  /// Shortens the forces of a linearization if the model specifies points by components with sines and
  /// cosines.
  constexpr void gather(sequence<expression>& f, sequence<expression>& more_f) {
    if (!has_sines_in_components(m_, loads_)) return;
    sequence<expression> all = f, others = dependent().on_independent.entries;
    all.append(more_f), others.append(mass().entries);
    const sequence<expression> shorter = gathered(*m_.g, all, others);
    for (int i = 0; i < all.size(); ++i) (i < f.size() ? f[i] : more_f[i - f.size()]) = shorter[i];
  }

  /// u̇ of all speeds.
  constexpr const sequence<expression>& accelerations() {
    if (udot_.empty()) udot_ = of_all_speeds(solved_for_accelerations());
    return udot_;
  }

  /// Whether u̇ follows from articulated bodies without M, because the model determines it or because the
  /// elimination of M would cost more, whatever its entries are. M is then not formed.
  constexpr bool solves_without_mass() {
    if (is_solution_chosen_) return !without_mass_.x.empty();
    is_solution_chosen_ = true;
    const formulation& form = m_.formulated;
    if (!is_tree() || form.speeds == internal_speeds::absolute || has_sines_in_components(m_, loads_))
      return false;
    const bool is_given = form.solved_by == solution::articulated_bodies;
    if (!is_given && (form.solved_by != solution::cheapest || !is_too_long())) return false;
    const sequence<expression>& f = force();
    symbolic::symmetric_solution solved = articulated_bodies(s_).solve(f);
    if (is_given || costs_less_than_elimination(s_, solved, f, form.weights))
      without_mass_ = std::move(solved);
    return !without_mass_.x.empty();
  }

  /// The pivots of the solution without M.
  constexpr const sequence<symbolic::pivot>& pivots_without_mass() const { return without_mass_.pivots; }

  /// Compares these pivots with the diagonal entries of M, which are returned.
  constexpr sequence<expression> compare_pivots_with_diagonal() {
    const sequence<expression> diagonal = diagonal_of_mass_matrix(s_);
    for (symbolic::pivot& p : without_mass_.pivots) p.entry = diagonal[p.place];
    return diagonal;
  }

  /// u̇ of all speeds by the elimination of M, which derivatives of u̇ need in any case.
  constexpr const sequence<expression>& accelerations_by_elimination() {
    if (!accelerations().empty() && !has_other_form_) return udot_;
    if (udot_by_elimination_.empty())
      udot_by_elimination_ = of_all_speeds(symbolic::solve_symmetric(*m_.g, mass(), force()));
    return udot_by_elimination_;
  }

  /// Whether u̇, once formed, follows from articulated bodies or from other speeds than those of the model.
  constexpr bool has_other_form() const { return has_other_form_; }

  /// The pivots of the mass matrix in the solution for the accelerations.
  constexpr const sequence<symbolic::pivot>& pivots() const { return pivots_; }

  /// F_i + Aᵀ F_d.
  constexpr sequence<expression> reduce(const sequence<expression>& forces) {
    return reduced(forces, speeds_, dependent().on_independent);
  }
  /// The same for each column of a matrix.
  constexpr symbolic::matrix reduce(const symbolic::matrix& columns) {
    symbolic::matrix all(*m_.g, speeds_.independent.size(), columns.columns);
    for (int j = 0; j < columns.columns; ++j) {
      sequence<expression> force;
      for (int i = 0; i < columns.rows; ++i) force.push(columns(i, j));
      const sequence<expression> found = reduce(force);
      for (int i = 0; i < found.size(); ++i) all(i, j) = found[i];
    }
    return all;
  }

  /// F_r for the independent speeds.
  constexpr sequence<expression> active_forces() {
    if (by_lagrange()) return reduce(lagrange_.active_forces());
    return reduce(mechanics::active_forces(s_, loads_));
  }

  /// F_r* for all speeds at u̇ = 0; with Kane's method, followed by F_r* of the auxiliary speeds.
  constexpr sequence<expression> inertia_bias() const {
    if (by_lagrange()) return lagrange_.inertia_bias();
    return mechanics::inertia_bias(s_);
  }

  /// F_r* = −M u̇ + (F_r* at u̇ = 0) for the independent speeds, with the symbols u̇.
  constexpr sequence<expression> inertia_forces() {
    sequence<expression> force = inertia_bias();
    for (int i = 0; i < m_.speeds.size(); ++i)
      for (int j = 0; j < m_.speeds.size(); ++j) force[i] -= free_mass()(i, j) * m_.speed_rates[j];
    return reduce(force);
  }

  /// F_r + F_r* for all speeds, with the symbols u̇, before constraints reduce them.
  constexpr sequence<expression> unreduced_forces() {
    sequence<expression> force;
    if (by_lagrange())
      force = lagrange_.forcing(m_.speed_rates);
    else
      force = forcing(s_, loads_, m_.speed_rates);
    force.resize(m_.speeds.size()); // the auxiliary speeds come last
    return force;
  }

  /// M and f in M u̇ = f for all speeds, before constraints reduce them.
  constexpr symbolic::matrix unreduced_mass() {
    return leading_block(*m_.g, free_mass(), m_.speeds.size(), m_.speeds.size());
  }
  constexpr sequence<expression> unreduced_forcing() {
    sequence<expression> force = free_force();
    force.resize(m_.speeds.size()); // the auxiliary speeds come last
    return force;
  }

  /// The generalized inertia forces for all speeds in a motion with the symbols u̇, including gravity: F_r*
  /// on accelerated ground for Kane's method, ∂L/∂q − d/dt ∂L/∂q̇ for Lagrange's.
  constexpr sequence<expression> inertia_in(motion& on_accelerated_ground) {
    if (by_lagrange()) return lagrange_.inertia_forces(m_.speed_rates);
    return mechanics::inertia_forces(s_, on_accelerated_ground);
  }

  /// For all speeds, the generalized forces that `inertia_in` does not include.
  constexpr sequence<expression> forces_of_loads() {
    if (by_lagrange()) return lagrange_.forces_of_loads();
    return mechanics::forces_of_loads(s_, loads_);
  }

  /// λ, one for each constraint.
  constexpr const symbolic::matrix& lambda() {
    if (!has_lambda_)
      lambda_ = multipliers(*m_.g, constraints_, speeds_, residual_forces_of(speeds_.dependent)).x;
    has_lambda_ = true;
    return lambda_;
  }

  /// The forces that keep the auxiliary speeds at zero.
  constexpr sequence<expression> noncontributing_forces() {
    sequence<int> auxiliary;
    for (int w = m_.speeds.size(); w < m_.ways(); ++w) auxiliary.push(w);
    const symbolic::matrix& of_constraints = lambda();
    return mechanics::noncontributing_forces(constraints_, of_constraints, residual_forces_of(auxiliary));
  }

private:
  /// Whether M is never worth its cost: whatever its entries are, or because a model with many speeds states
  /// articulated bodies. f then has no parts in common with it.
  constexpr bool is_too_long() const {
    constexpr int many = 16;
    if (!is_tree() || has_sines_in_components(m_, loads_)) return false;
    const formulation& form = m_.formulated;
    if (form.solved_by == solution::articulated_bodies) return s_.model->speeds_of_motion() >= many;
    return is_too_long_for_elimination(s_, form.weights);
  }

  /// u̇ of the independent speeds, in the form that the model determines, otherwise in the cheapest one.
  constexpr symbolic::symmetric_solution solved_for_accelerations() {
    if (solves_without_mass()) {
      has_other_form_ = true;
      if (mass_.rows != 0)
        for (symbolic::pivot& p : without_mass_.pivots) p.entry = mass_(p.place, p.place);
      return without_mass_;
    }
    const symbolic::matrix& m = mass();
    const sequence<expression>& f = force();
    if (!is_tree()) return symbolic::solve_symmetric(*m_.g, m, f);
    const formulation& form = m_.formulated;
    const bool is_given = form.solved_by == solution::articulated_bodies;
    if (form.speeds == internal_speeds::absolute) {
      const absolute_speeds internal(s_);
      has_other_form_ = internal.is_any();
      if (has_other_form_) return internal.solve(loads_, is_given);
    }
    const bool is_open = form.solved_by == solution::cheapest;
    if (is_given || (is_open && may_pay_by_articulated_bodies(s_, m, f, form.weights))) {
      symbolic::symmetric_solution solved = articulated_bodies(s_).solve(f);
      for (symbolic::pivot& p : solved.pivots) p.entry = m(p.place, p.place);
      has_other_form_ = is_given || cost_of(solved).weighted(form.weights) <
                                        cost_by_elimination(m, f).weighted(form.weights);
      if (has_other_form_) return solved;
    }
    return symbolic::solve_symmetric(*m_.g, m, f);
  }

  /// Adds the rates of the dependent speeds to a solution, and stores its pivots.
  constexpr sequence<expression> of_all_speeds(const symbolic::symmetric_solution& solved) {
    const sequence<expression>& independent = solved.x;
    pivots_.append(solved.pivots);
    sequence<expression> udot(m_.speeds.size(), m_.zero());
    for (int i = 0; i < independent.size(); ++i) udot[speeds_.independent[i]] = independent[i];
    const sequence<expression> rates =
        solved_for_dependent(dependent().on_independent, independent, dependent().acceleration_bias);
    for (int d = 0; d < rates.size(); ++d) udot[speeds_.dependent[d]] = rates[d];
    return udot;
  }

  /// Whether the mass matrix is that of a tree of rigid bodies without constraints.
  constexpr bool is_tree() const {
    return !by_lagrange() && speeds_.dependent.empty() && s_.flexible_parts.empty();
  }

  constexpr sequence<expression> formed_force() {
    const sequence<expression>& free = free_force();
    const dependent_speeds& solved = dependent();
    return reduced_force(free, speeds_, solved, coupling());
  }

  /// Shortens the mass matrix and the forces if sines of components cancel in them, and takes out common
  /// parts. What the rates of dependent speeds and derivatives need in any case remains unchanged.
  constexpr void shorten_mass_and_force() {
    mass_and_force both(*m_.g, mass_, force_);
    sequence<int> others = symbolic::nodes_of(dependent().on_independent.entries);
    others.append(symbolic::nodes_of(dependent().acceleration_bias));
    if (has_sines_in_components(m_, loads_)) both.gather(others);
    if (is_too_long()) return;
    if (!speeds_.dependent.empty()) {
      others.append(symbolic::nodes_of(coupling().entries));
      others.append(symbolic::nodes_of(free_mass().entries));
    }
    both.factor(others);
  }

  constexpr bool by_lagrange() const { return m_.derived_by == method::lagrange; }

  constexpr void take_acceleration_constraints() {
    const symbolic::linear_solution given =
        solve_acceleration_constraints(*m_.g, linear_in_speed_rates(s_, constraints_), speeds_);
    for (int d = 0; d < speeds_.dependent.size(); ++d) dependent_.acceleration_bias[d] = given.x(d, 0);
    for (const symbolic::solved_block& b : given.blocks) dependent_.blocks.push(b);
  }

  /// M and f for all speeds, including auxiliary speeds, without constraints.
  constexpr const symbolic::matrix& free_mass() {
    if (free_mass_.rows != 0) return free_mass_;
    if (by_lagrange())
      free_mass_ = lagrange_.mass_matrix();
    else
      free_mass_ = mass_matrix(s_);
    return free_mass_;
  }
  constexpr const sequence<expression>& free_force() {
    if (!free_force_.empty()) return free_force_;
    if (by_lagrange())
      free_force_ = lagrange_.forcing();
    else
      free_force_ = forcing(s_, loads_);
    return free_force_;
  }
  constexpr sequence<expression> residual_forces_of(const sequence<int>& ways) {
    const symbolic::matrix& mass = free_mass();
    const sequence<expression>& force = free_force();
    return residual_forces(mass, force, accelerations(), ways);
  }

  const skeleton& s_;
  const mechanism& m_;
  const loads& loads_;
  const constraints& constraints_;
  const partition& speeds_;
  lagrange_equations lagrange_{s_, loads_};
  bool has_dependent_ = false, has_coupling_ = false, has_lambda_ = false, has_other_form_ = false;
  sequence<expression> bias_{};
  dependent_speeds dependent_{};
  symbolic::matrix free_mass_{}, coupling_{}, mass_{}, lambda_{};
  sequence<expression> free_force_{}, force_{}, udot_{}, udot_by_elimination_{};
  sequence<symbolic::pivot> pivots_{};
  symbolic::symmetric_solution without_mass_{}; ///< empty if M is needed
  bool is_solution_chosen_ = false;
};

} // namespace kanexpr::mechanics
