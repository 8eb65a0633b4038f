#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/checks/check_constraints.hpp>
#include <kanexpr/mechanics/checks/check_coriolis.hpp>
#include <kanexpr/mechanics/checks/check_lagrange.hpp>
#include <kanexpr/mechanics/checks/regular_mass.hpp>
#include <kanexpr/mechanics/constraints/configuration_step.hpp>
#include <kanexpr/mechanics/constraints/redundant_constraints.hpp>
#include <kanexpr/mechanics/dynamics/coriolis.hpp>
#include <kanexpr/mechanics/dynamics/dynamics.hpp>
#include <kanexpr/mechanics/dynamics/energy.hpp>
#include <kanexpr/mechanics/dynamics/minimal.hpp>
#include <kanexpr/mechanics/dynamics/regressor.hpp>
#include <kanexpr/mechanics/dynamics/required_inputs.hpp>
#include <kanexpr/mechanics/dynamics/singularity_check.hpp>
#include <kanexpr/mechanics/linearize/linearized_equations.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/motion/known_motion.hpp>
#include <kanexpr/mechanics/multibody_system.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/mechanics/skeleton/substituted_rates.hpp>
#include <kanexpr/symbolic/derivatives/jacobian.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/sizes/term_sizes.hpp>

#include <utility>

namespace kanexpr::mechanics {

/// The equations of one system. Each result is formed on first use and only once.
///
/// Constraints are processed by `constrain`, at the latest when the first result is requested.
class equations {
public:
  constexpr explicit equations(const multibody_system& of) : equations(of, known_motion(of.mechanism)) {}
  /// Reuses the motion that was derived while loads and constraints were read.
  constexpr equations(const multibody_system& of, known_motion&& known)
      : system_(&of), m_(&of.mechanism), known_(std::move(known)) {}
  /// Creates an empty object to be restored from stored members.
  using for_restore = known_motion::for_restore;
  constexpr equations(const multibody_system& of, for_restore empty)
      : equations(of, known_motion(of.mechanism, empty)) {}
  equations(const equations&) = delete;
  equations& operator=(const equations&) = delete;

  /// The stored members, except those that are cheap to form again. Only valid systems are stored.
  template <class Self, class Visit>
  static constexpr void each_member(Self& self, Visit&& visit) {
    visit(self.known_, self.constraints_, self.configuration_, self.speeds_, self.coordinates_,
          self.step_blocks_, self.input_blocks_, self.dynamics_, self.is_constrained_, self.is_mass_checked_,
          self.is_mass_regular_, self.is_solution_checked_, self.linearized_);
  }

  /// Forms the constraints on the speeds and chooses the dependent speeds and coordinates.
  constexpr void constrain() {
    is_constrained_ = true;
    const given_constraints& all = system_->constraints;
    const bool is_all_solved = all.redundant.empty();
    given_constraints fewer;
    if (!is_all_solved) fewer = without_redundant(all);
    const given_constraints& given = is_all_solved ? all : fewer;
    mistake_ = check_redundant(all);
    if (!mistake_) mistake_ = check_contents_of_constraints(*m_, all);
    if (!mistake_ && m_->derived_by == method::lagrange) mistake_ = check_lagrange(moving(), system_->loads);
    if (mistake_) return;
    constraints_ = form_constraints(moving(), given);
    record_redundant(all, constraints_);
    configuration_ = symbolic::forward_jacobian(*m_->g, given.on_configuration, m_->coordinates);
    const sequence<numbers> by_q = equilibrated(at_generic_states(configuration_, m_)),
                            by_u = equilibrated(at_generic_states(constraints_.jacobian, m_));
    mistake_ = check_constraints(s_, constraints_, configuration_, by_q, by_u);
    if (!mistake_) mistake_ = check_choice(*m_, given, constraints_, configuration_, by_q, by_u);
    if (!mistake_) mistake_ = check_acceleration_constraints(s_, constraints_, configuration_);
    if (!mistake_ && !constraints_.redundant.empty())
      mistake_ = check_redundant_rates(s_, constraints_, configuration_, rates_of_redundant());
    if (mistake_) return;
    coordinates_ = partition_of(by_q, configuration_, given.dependent_coordinates,
                                sequence<char>(m_->coordinates.size(), 0));
    speeds_ = partition_of(by_u, constraints_.jacobian, given.dependent_speeds,
                           rates_of_dependent(s_, coordinates_));
    known_.drop_auxiliary_speeds();
  }

  constexpr const skeleton& skeleton_used() const { return s_; }
  constexpr const loads& loads_used() const { return system_->loads; }
  constexpr const constraints& constraints_used() const { return constraints_; }
  constexpr const partition& speeds() const { return speeds_; }
  constexpr const partition& coordinates() const { return coordinates_; }
  /// Whether u̇, once formed, follows from articulated bodies or from other speeds than those of the model.
  constexpr bool has_other_form() const { return dynamics_.has_other_form(); }

  /// Rejects results that need bodies if the model gives a Lagrangian instead.
  constexpr sentence check_bodies(quantity wanted) const {
    if (!row_of(wanted).is_of_bodies || !system_->loads.has_lagrangian) return {};
    return sentence({"energies, momenta, the mass center and the regressor require bodies; a system given by "
                     "a Lagrangian has none"});
  }

  /// A mistake that was found only during the derivation.
  constexpr const sentence& mistake() const { return mistake_; }

  constexpr symbolic::matrix get(quantity wanted) {
    if (!is_constrained_) constrain();
    if (!mistake_) mistake_ = check_bodies(wanted);
    switch (kind_of(wanted)) {
    case result_kind::equations_of_motion: return equation_of_motion(wanted);
    case result_kind::forces: return of_forces(wanted);
    case result_kind::energies: return of_energies(wanted);
    case result_kind::configuration_constraints: return of_configuration_constraints(wanted);
    case result_kind::velocity_constraints: return of_velocity_constraints(wanted);
    case result_kind::derivatives: return of_derivatives(wanted);
    }
    return {};
  }

  /// A result with the symbols u̇, for callers that supply the rates of the speeds.
  constexpr symbolic::matrix at_given_rates(quantity wanted) {
    if (!is_sound()) return {};
    if (is_of_linearization(wanted) || is_to_second_order(wanted)) return linearized().get(wanted);
    return get(wanted);
  }

  /// The linearized equations.
  constexpr linearized_equations& linearized() {
    if (!is_constrained_) constrain();
    return linearized_;
  }

  /// The derivatives of the rates q̇ and u̇ with respect to the given parameters, one column for each; u̇ are
  /// symbols.
  constexpr symbolic::matrix sensitivity_to(const sequence<expression>& parameters) {
    if (!is_sound()) return {};
    return linearized_.to_second_order().rates_by(parameters);
  }

  /// Substitutes the rates q̇ and u̇ from the equations of motion into an expression.
  constexpr expression in_motion(expression e) { return in_motion(column({e})).entries[0]; }
  constexpr symbolic::matrix in_motion(symbolic::matrix m) {
    m = at_coordinate_rates(s_, std::move(m));
    if (!has_speed_rates(*m_, m)) return m;
    return at_speed_rates(*m_, std::move(m), accelerations());
  }

  /// Substitutes the dependent speeds from the constraints into an expression, unless a constraint is not
  /// linear in the speeds.
  constexpr expression imposed(expression e) {
    symbolic::substitution bound(*m_->g);
    const sequence<expression> given = dynamics_.speeds_by_constraints();
    for (int d = 0; d < given.size() && constraints_.nonlinear == 0; ++d)
      bound.replace(m_->speeds[speeds_.dependent[d]], given[d]);
    return bound.in(without_auxiliary_speeds(*m_).in(known_rates(*m_, s_.coordinate_rates).in(e)));
  }

  /// The checks for singular systems on which the given results depend; the last one checks that the results
  /// are finite.
  constexpr sequence<singularity_check> singularity_checks_of(const sequence<int>& outputs) {
    sequence<singularity_check> all = checks_of_rates(*m_, s_.rate_blocks);
    if (dynamics_.has_dependent()) all.append(checks_of_speeds(*m_, speeds_, dynamics_.dependent().blocks));
    all.append(checks_of_coordinates(*m_, coordinates_, step_blocks_));
    all.append(checks_of_inputs(*m_, input_blocks_));
    all.append(checks_of_coordinates(*m_, coordinates_, linearized_.coordinate_blocks()));
    sequence<int> sure_divisors;
    if (is_mass_regular_)
      for (const symbolic::pivot& p : pivots()) sure_divisors.push(p.key);
    else
      all.append(checks_of_mass(*m_, speeds_, pivots()));
    return needed_checks(*m_, all, sure_divisors, outputs);
  }

  /// The unsubstituted velocities and accelerations, with the symbols u̇.
  constexpr motion& moving() { return known_.moving(); }
  constexpr known_motion& known() { return known_; }

private:
  constexpr symbolic::matrix of_derivatives(quantity wanted) {
    symbolic::matrix m = at_coordinate_rates(s_, at_given_rates(wanted));
    if (!has_speed_rates(*m_, m)) return m;
    mass(); // may report a mistake
    return at_speed_rates(*m_, std::move(m), dynamics_.accelerations_by_elimination());
  }

  constexpr bool is_sound() {
    if (!is_constrained_) constrain();
    if (!mistake_) mass(); // may report a mistake
    return !mistake_;
  }

  constexpr symbolic::matrix equation_of_motion(quantity wanted) {
    switch (wanted) {
    case quantity::mass_matrix: return mass();
    case quantity::forcing: return column(dynamics_.force());
    case quantity::mass_matrix_full: {
      const symbolic::matrix& formed = mass();
      return mass_matrix_of_all(*m_, speeds_, formed, dynamics_.dependent());
    }
    case quantity::forcing_full: {
      const sequence<expression>& force = dynamics_.force();
      return column(s_.coordinate_rates, forcing_of_all(force, dynamics_.dependent()));
    }
    case quantity::qdot: return column(s_.coordinate_rates);
    case quantity::udot: return column(accelerations());
    case quantity::rhs: return column(s_.coordinate_rates, accelerations());
    default: return {};
    }
  }
  constexpr symbolic::matrix of_forces(quantity wanted) {
    switch (wanted) {
    case quantity::active_forces: return column(dynamics_.active_forces());
    case quantity::inertia_forces: return column(dynamics_.inertia_forces());
    case quantity::unreduced_forces: return column(dynamics_.unreduced_forces());
    case quantity::unreduced_mass_matrix: return dynamics_.unreduced_mass();
    case quantity::unreduced_forcing: return column(dynamics_.unreduced_forcing());
    case quantity::constraint_bias: return column(dynamics_.constraint_bias());
    case quantity::inverse_dynamics: return column(negative(dynamics_.reduce(dynamics_.unreduced_forces())));
    case quantity::required_inputs: return inputs_of_motion();
    case quantity::gravity_compensation: return column(negative(dynamics_.reduce(forces_of_gravity())));
    case quantity::load_compensation:
      return column(negative(dynamics_.reduce(forces_of_loads(s_, system_->loads))));
    case quantity::regressor: return regressor();
    case quantity::inertial_parameters: return inertial_parameters();
    case quantity::coriolis: return coriolis();
    default: return {};
    }
  }
  constexpr symbolic::matrix of_energies(quantity wanted) {
    switch (wanted) {
    case quantity::kinetic_energy: return column({mechanics::kinetic_energy(moving())});
    case quantity::potential_energy: return column({mechanics::potential_energy(s_, system_->loads)});
    case quantity::linear_momentum: return column(mechanics::linear_momentum(moving()));
    case quantity::angular_momentum: return column(mechanics::angular_momentum(moving()));
    case quantity::center_of_mass: return column(mechanics::center_of_mass(s_));
    case quantity::generalized_momenta: return column(momenta());
    default: return {};
    }
  }
  constexpr symbolic::matrix of_configuration_constraints(quantity wanted) {
    switch (wanted) {
    case quantity::configuration_residual: return column(constraints_.on_configuration);
    case quantity::configuration_terms:
      return column(symbolic::terms_of(*m_->g, constraints_.on_configuration));
    case quantity::redundant_residual: return column(constraints_.redundant);
    case quantity::redundant_terms: return column(symbolic::terms_of(*m_->g, constraints_.redundant));
    case quantity::redundant_jacobian: return only_redundant(moving(), constraints_).jacobian;
    case quantity::redundant_bias: return column(dynamics_.bias_of(only_redundant(moving(), constraints_)));
    case quantity::redundant_rate: return column(rates_of_redundant());
    case quantity::redundant_rate_terms: return column(symbolic::terms_of(*m_->g, rates_of_redundant()));
    case quantity::configuration_jacobian_by_dependent:
      return detail::columns_of(*m_->g, configuration_, coordinates_.dependent);
    case quantity::configuration_jacobian_by_all: return configuration_;
    case quantity::configuration_step: return step_of_configuration();
    default: return {};
    }
  }
  constexpr symbolic::matrix of_velocity_constraints(quantity wanted) {
    switch (wanted) {
    case quantity::velocity_residual: return column(constraints_.velocity_residual());
    case quantity::velocity_terms:
      return column(symbolic::terms_of(*m_->g, constraints_.velocity_residual()));
    case quantity::constraint_residual:
      return column(constraints_.on_configuration, constraints_.velocity_residual());
    case quantity::constraint_jacobian: return constraints_.jacobian;
    case quantity::dependent_speeds: return column(dynamics_.speeds_by_constraints());
    case quantity::dependency: return dynamics_.dependent().on_independent;
    case quantity::acceleration_bias: return column(dynamics_.dependent().acceleration_bias);
    case quantity::constraint_pivots: return column(dynamics_.constraint_pivots());
    case quantity::multipliers: return dynamics_.lambda();
    case quantity::noncontributing_forces: return column(dynamics_.noncontributing_forces());
    default: return {};
    }
  }

  constexpr void take(const checked_mass& found) {
    mistake_ = found.mistake;
    is_mass_regular_ = found.is_regular;
  }

  constexpr const symbolic::matrix& mass() {
    const symbolic::matrix& formed = dynamics_.mass();
    if (mistake_ || is_mass_checked_) return formed;
    is_mass_checked_ = true;
    take(check_regular_mass(s_, speeds_, formed, system_->loads.has_lagrangian));
    return formed;
  }
  constexpr sequence<symbolic::pivot> pivots() const {
    sequence<symbolic::pivot> all = dynamics_.pivots();
    all.append(linearized_.pivots());
    return all;
  }
  constexpr const sequence<expression>& accelerations() {
    if (is_solution_checked_) return dynamics_.accelerations();
    is_solution_checked_ = true;
    if (is_mass_checked_ || !dynamics_.solves_without_mass())
      mass(); // may report a mistake
    else if (!mistake_)
      take(check_regular_pivots(s_, speeds_, dynamics_));
    return dynamics_.accelerations();
  }
  constexpr sequence<expression> forces_of_gravity() const {
    sequence<expression> forces = mechanics::forces_of_gravity(s_, system_->loads);
    forces.resize(m_->speeds.size()); // the auxiliary speeds come last
    return forces;
  }

  constexpr symbolic::matrix inputs_of_motion() {
    if (mistake_) return {};
    const required_inputs found = inputs_for(*m_, dynamics_.reduce(dynamics_.unreduced_forces()));
    mistake_ = found.mistake;
    input_blocks_ = found.solved.blocks;
    return found.solved.x;
  }

  constexpr symbolic::matrix inertial_parameters() {
    if (!mistake_) mistake_ = check_rigidity(*m_);
    if (mistake_) return {};
    return column(inertial_values(s_));
  }

  constexpr symbolic::matrix regressor() {
    if (!mistake_) mistake_ = check_rigidity(*m_);
    motion k = motion_on_accelerated_ground(s_, system_->loads, m_->speed_rates);
    if (!mistake_) mistake_ = check_regressor(s_, k);
    if (mistake_) return {};
    return dynamics_.reduce(regressor_of_all(s_, k));
  }

  constexpr symbolic::matrix coriolis() {
    const speeds_as_rates known = coordinates_of_speeds(s_);
    if (!mistake_) mistake_ = known.mistake;
    if (!mistake_ && constraints_.size() != 0)
      mistake_ = sentence({"the Coriolis matrix requires a system without constraints"});
    if (mistake_) return {};
    sequence<expression> by_speeds = momenta();
    symbolic::substitution at_rest(*m_->g); // keeps the contribution of prescribed motions
    for (const expression& u : m_->speeds) at_rest.replace(u, m_->zero());
    for (expression& p : by_speeds) p -= at_rest.in(p);
    const symbolic::matrix c = coriolis_matrix(*m_, known.coordinate, mass(), by_speeds);
    if (mistake_) return c;
    motion& k = moving();
    mistake_ = check_coriolis(k, system_->loads, mass(), c, [&] { return dynamics_.inertia_bias(); });
    return c;
  }

  /// ∂T/∂u, or ∂L/∂q̇ if the model gives a Lagrangian.
  constexpr sequence<expression> momenta() {
    if (system_->loads.has_lagrangian) return gradient_of(*m_, system_->loads.lagrangian).momenta;
    return gradient_of(*m_, mechanics::kinetic_energy(moving())).momenta;
  }

  constexpr symbolic::matrix step_of_configuration() {
    const symbolic::linear_solution solved =
        configuration_step(*m_, constraints_.on_configuration, configuration_, coordinates_);
    step_blocks_ = solved.blocks;
    return solved.x;
  }

  constexpr sequence<expression> rates_of_redundant() {
    known_rates known(*m_, s_.coordinate_rates);
    without_auxiliary_speeds drop(*m_);
    sequence<expression> rates;
    for (const expression& f : constraints_.redundant) rates.push(drop.in(known.in(moving().rate(f))));
    return rates;
  }
  constexpr symbolic::matrix column(const sequence<expression>& above,
                                    const sequence<expression>& below = {}) const {
    symbolic::matrix m(*m_->g, 0, 1);
    m.rows = above.size() + below.size();
    m.entries.append(above), m.entries.append(below);
    return m;
  }
  constexpr symbolic::matrix column(const components& v) const {
    return column(sequence<expression>{v.x, v.y, v.z});
  }

  const multibody_system* system_;
  const mechanism* m_;
  known_motion known_;
  const skeleton& s_ = known_.skeleton_used();
  sentence mistake_{};
  constraints constraints_{};
  symbolic::matrix configuration_{}; ///< the Jacobian of the configuration constraints with respect to all
                                     ///< coordinates
  partition speeds_{}, coordinates_{};
  sequence<symbolic::solved_block>
      step_blocks_{}; ///< the blocks of the Newton step of the dependent coordinates
  sequence<symbolic::solved_block> input_blocks_{}; ///< the blocks of the required inputs
  dynamics dynamics_{s_, system_->loads, constraints_, speeds_};
  bool is_constrained_ = false, is_mass_checked_ = false, is_mass_regular_ = false,
       is_solution_checked_ = false;
  linearized_equations linearized_{
      {s_, system_->loads, constraints_, configuration_, coordinates_, speeds_, dynamics_}};
};

} // namespace kanexpr::mechanics
