#pragma once

#include <string_view>

namespace kanexpr::mechanics {

/// The results available for a system. Each is a matrix of expressions; n is the number of coordinates, p the
/// number of speeds, m the number of constraints on the speeds, and l the number of configuration
/// constraints.
enum class quantity : unsigned char {
  mass_matrix,           ///< M for the independent speeds, (p−m)×(p−m)
  forcing,               ///< f in M u̇ = f, p−m
  mass_matrix_full,      ///< M_full of [q̇; u̇], (n+p)×(n+p): E, M and the differentiated constraints
  forcing_full,          ///< [q̇; f; …], n+p, with M_full [q̇; u̇] = f_full
  qdot,                  ///< q̇, n
  udot,                  ///< u̇ of all speeds, p
  rhs,                   ///< [q̇; u̇], n+p
  active_forces,         ///< F_r for the independent speeds, p−m
  inertia_forces,        ///< F_r* for the independent speeds, p−m, with the symbols u̇
  unreduced_forces,      ///< F_r + F_r* for all speeds before constraints reduce them, p, with the symbols u̇
  unreduced_mass_matrix, ///< M for all speeds before constraints reduce it, p×p
  unreduced_forcing,     ///< f for all speeds before constraints reduce it, p
  constraint_bias,       ///< γ in J u̇ + γ = 0, m
  inverse_dynamics,      ///< generalized forces required in addition to the loads, p−m, with the symbols u̇
  required_inputs,       ///< the inputs that produce u̇, s = p−m, with the symbols u̇
  gravity_compensation,  ///< generalized forces for the independent speeds that balance gravity, p−m
  load_compensation,     ///< generalized forces for the independent speeds that balance all other loads, p−m
  regressor,             ///< Y in the inverse dynamics τ = Y π + τ_0 for b inertial parameters, (p−m)×b
  inertial_parameters,   ///< π with the values given in the model, b
  coriolis,              ///< C with Ṁ − 2C skew-symmetric, if the speeds are coordinate rates, p×p
  kinetic_energy,
  potential_energy,       ///< the energy of gravity, springs and given potential energies
  linear_momentum,        ///< 3, inertial axes
  angular_momentum,       ///< 3, inertial axes, about the origin
  center_of_mass,         ///< 3, inertial axes, from the origin
  generalized_momenta,    ///< ∂T/∂u, or ∂L/∂q̇, for all speeds before constraints reduce them, p
  configuration_residual, ///< values of the configuration constraints, l
  configuration_terms,    ///< magnitude of the terms of this residual, l
  redundant_residual,     ///< residual of the redundant constraints
  redundant_terms,        ///< magnitude of the terms of this residual
  redundant_jacobian,     ///< J of the rates of the redundant constraints, a column for each speed
  redundant_bias,         ///< γ in J u̇ + γ = 0 for the redundant constraints
  redundant_rate,         ///< the rates of the redundant constraints
  redundant_rate_terms,   ///< magnitude of the terms of these rates
  configuration_jacobian_by_dependent, ///< derivatives of the residual with respect to the dependent
                                       ///< coordinates, l×l
  configuration_jacobian_by_all,       ///< derivatives of the residual with respect to all coordinates, l×n
  configuration_step,                  ///< Newton step of the dependent coordinates, l
  velocity_residual,      ///< residual of the velocity constraints, then of the rates of configuration
                          ///< constraints, m
  velocity_terms,         ///< magnitude of the terms of this residual, m
  constraint_residual,    ///< both residuals, l+m
  constraint_jacobian,    ///< J in J u + c = 0, m×p
  dependent_speeds,       ///< u_d in terms of the independent speeds, m; if a constraint is not linear in the
                          ///< speeds, u_d after one Newton step
  dependency,             ///< A in u̇_d = A u̇_i + b, m×(p−m)
  acceleration_bias,      ///< b in u̇_d = A u̇_i + b, m
  constraint_pivots,      ///< the determinants of the blocks that are solved for the dependent speeds, m
  multipliers,            ///< the generalized forces of the constraints: F_r + F_r* + Σ λ_j J_jr = 0, m
  noncontributing_forces, ///< the forces that keep the auxiliary speeds at zero, one for each
  state_matrix,           ///< A in δ[q̇_i; u̇_i] = A δ[q_i; u_i] + B δr, (n−l+p−m)×(n−l+p−m)
  input_matrix,           ///< B, (n−l+p−m)×s
  state_jacobian,         ///< ∂[q̇; u̇]/∂[q; u] without constraints on the state, (n+p)×(n+p)
  input_jacobian,         ///< ∂[q̇; u̇]/∂r, (n+p)×s
  implicit_mass_matrix,   ///< M in M δ[q̇; u̇; λ] = A δ[q_i; u_i] + B δr, (n+p+k)×(n+p+k)
  implicit_state_matrix,  ///< A, (n+p+k)×(n−l+p−m)
  implicit_input_matrix,  ///< B, (n+p+k)×s
  weighted_gradient, ///< ∂(λᵀẋ)/∂z for z = [q; u; r] and n+p weights λ, without constraints on the state,
                     ///< n+p+s
  directional_derivative,                    ///< (∂ẋ/∂z) v for a direction v, n+p
  weighted_hessian,                          ///< ∂²(λᵀẋ)/∂z², symmetric, (n+p+s)×(n+p+s)
  weighted_hessian_product,                  ///< ∂²(λᵀẋ)/∂z² v, n+p+s
  auxiliary_forces = noncontributing_forces, ///< alternative name
};

/// The quantity that determines the number of rows or columns of a result.
enum class extent_by : unsigned char {
  scalar,
  one,
  three,
  coordinates,               ///< n
  speeds,                    ///< p
  coordinates_and_speeds,    ///< n+p
  independent_speeds,        ///< p−m
  configuration_constraints, ///< l
  redundant_constraints,
  speed_constraints, ///< m
  all_constraints,   ///< l+m
  auxiliary_speeds,
  inputs,              ///< s
  independent_states,  ///< n−l+p−m
  unknowns,            ///< n+p+k
  state_and_inputs,    ///< n+p+s
  inertial_parameters, ///< b: a mass for each particle, ten for each rigid body
};

/// The stage of the derivation that a result requires.
enum class stage : unsigned char {
  constrained, ///< positions, velocities and constraints
  equations,   ///< the equations of motion
  linearized,
};

/// A row of the table of all results.
struct result_row {
  quantity is{};
  std::string_view called{}; ///< the name by which it is requested
  extent_by rows{}, columns{};
  stage needs{};
  bool is_of_bodies = false;      ///< not available if the model gives a Lagrangian instead of bodies
  bool holds_speed_rates = false; ///< depends on the symbols u̇, which are passed to its function
  bool takes_weights = false;     ///< depends on the weights λ of ẋ, which are passed to its function
  bool takes_direction = false;   ///< depends on the direction v of z, which is passed to its function
};

namespace detail {

using std::string_view_literals::operator""sv; // compilers need not count the letters

struct result_table {
  using q = quantity;
  using by = extent_by;
  using enum stage;
  static constexpr result_row rows[]{
      {q::mass_matrix, "mass_matrix"sv, by::independent_speeds, by::independent_speeds, equations},
      {q::forcing, "forcing"sv, by::independent_speeds, by::one, equations},
      {q::mass_matrix_full, "mass_matrix_full"sv, by::coordinates_and_speeds, by::coordinates_and_speeds,
       equations},
      {q::forcing_full, "forcing_full"sv, by::coordinates_and_speeds, by::one, equations},
      {q::qdot, "qdot"sv, by::coordinates, by::one, constrained},
      {q::udot, "udot"sv, by::speeds, by::one, equations},
      {q::rhs, "rhs"sv, by::coordinates_and_speeds, by::one, equations},
      {q::active_forces, "active_forces"sv, by::independent_speeds, by::one, equations},
      {q::inertia_forces, "inertia_forces"sv, by::independent_speeds, by::one, equations, false, true},
      {q::unreduced_forces, "unreduced_forces"sv, by::speeds, by::one, equations, false, true},
      {q::unreduced_mass_matrix, "unreduced_mass_matrix"sv, by::speeds, by::speeds, equations},
      {q::unreduced_forcing, "unreduced_forcing"sv, by::speeds, by::one, equations},
      {q::constraint_bias, "constraint_bias"sv, by::speed_constraints, by::one, equations},
      {q::inverse_dynamics, "inverse_dynamics"sv, by::independent_speeds, by::one, constrained, false, true},
      {q::required_inputs, "required_inputs"sv, by::inputs, by::one, constrained, false, true},
      {q::gravity_compensation, "gravity_compensation"sv, by::independent_speeds, by::one, constrained, true},
      {q::load_compensation, "load_compensation"sv, by::independent_speeds, by::one, constrained},
      {q::regressor, "regressor"sv, by::independent_speeds, by::inertial_parameters, constrained, true, true},
      {q::inertial_parameters, "inertial_parameters"sv, by::inertial_parameters, by::one, constrained, true},
      {q::coriolis, "coriolis"sv, by::speeds, by::speeds, constrained},
      {q::kinetic_energy, "kinetic_energy"sv, by::scalar, by::scalar, constrained, true},
      {q::potential_energy, "potential_energy"sv, by::scalar, by::scalar, constrained, true},
      {q::linear_momentum, "linear_momentum"sv, by::three, by::one, constrained, true},
      {q::angular_momentum, "angular_momentum"sv, by::three, by::one, constrained, true},
      {q::center_of_mass, "center_of_mass"sv, by::three, by::one, constrained, true},
      {q::generalized_momenta, "generalized_momenta"sv, by::speeds, by::one, constrained},
      {q::configuration_residual, "configuration_residual"sv, by::configuration_constraints, by::one,
       constrained},
      {q::configuration_terms, "configuration_terms"sv, by::configuration_constraints, by::one, constrained},
      {q::redundant_residual, "redundant_residual"sv, by::redundant_constraints, by::one, constrained},
      {q::redundant_terms, "redundant_terms"sv, by::redundant_constraints, by::one, constrained},
      {q::redundant_jacobian, "redundant_jacobian"sv, by::redundant_constraints, by::speeds, constrained},
      {q::redundant_bias, "redundant_bias"sv, by::redundant_constraints, by::one, equations},
      {q::redundant_rate, "redundant_rate"sv, by::redundant_constraints, by::one, constrained},
      {q::redundant_rate_terms, "redundant_rate_terms"sv, by::redundant_constraints, by::one, constrained},
      {q::configuration_jacobian_by_dependent, "configuration_jacobian_by_dependent"sv,
       by::configuration_constraints, by::configuration_constraints, constrained},
      {q::configuration_jacobian_by_all, "configuration_jacobian_by_all"sv, by::configuration_constraints,
       by::coordinates, constrained},
      {q::configuration_step, "configuration_step"sv, by::configuration_constraints, by::one, constrained},
      {q::velocity_residual, "velocity_residual"sv, by::speed_constraints, by::one, constrained},
      {q::velocity_terms, "velocity_terms"sv, by::speed_constraints, by::one, constrained},
      {q::constraint_residual, "constraint_residual"sv, by::all_constraints, by::one, constrained},
      {q::constraint_jacobian, "constraint_jacobian"sv, by::speed_constraints, by::speeds, constrained},
      {q::dependent_speeds, "dependent_speeds"sv, by::speed_constraints, by::one, equations},
      {q::dependency, "dependency"sv, by::speed_constraints, by::independent_speeds, equations},
      {q::acceleration_bias, "acceleration_bias"sv, by::speed_constraints, by::one, equations},
      {q::constraint_pivots, "constraint_pivots"sv, by::speed_constraints, by::one, equations},
      {q::multipliers, "multipliers"sv, by::speed_constraints, by::one, equations},
      {q::noncontributing_forces, "noncontributing_forces"sv, by::auxiliary_speeds, by::one, equations},
      {q::state_matrix, "explicit_form"sv, by::independent_states, by::independent_states, linearized},
      {q::input_matrix, "explicit_form"sv, by::independent_states, by::inputs, linearized},
      {q::state_jacobian, "jacobian"sv, by::coordinates_and_speeds, by::coordinates_and_speeds, equations},
      {q::input_jacobian, "jacobian"sv, by::coordinates_and_speeds, by::inputs, equations},
      {q::implicit_mass_matrix, "implicit_form"sv, by::unknowns, by::unknowns, equations},
      {q::implicit_state_matrix, "implicit_form"sv, by::unknowns, by::independent_states, equations},
      {q::implicit_input_matrix, "implicit_form"sv, by::unknowns, by::inputs, equations},
      {q::weighted_gradient, "gradient"sv, by::state_and_inputs, by::one, equations, false, false, true},
      {q::directional_derivative, "directional_derivative"sv, by::coordinates_and_speeds, by::one, equations,
       false, false, false, true},
      {q::weighted_hessian, "hessian"sv, by::state_and_inputs, by::state_and_inputs, equations, false, false,
       true},
      {q::weighted_hessian_product, "hessian_product"sv, by::state_and_inputs, by::one, equations, false,
       false, true, true},
  };
};

} // namespace detail

inline constexpr auto& results = detail::result_table::rows;

/// The rows are in the order of the quantities.
static_assert([] {
  int next = 0;
  for (const result_row& row : results)
    if (static_cast<int>(row.is) != next++) return false;
  return true;
}());

/// The kinds of results. Results of the same kind are adjacent in `quantity`.
enum class result_kind : unsigned char {
  equations_of_motion,
  forces,   ///< forces, and the matrices from which they are formed
  energies, ///< energies and momenta
  configuration_constraints,
  velocity_constraints,
  derivatives, ///< linearized equations, and derivatives with weights or a direction
};

constexpr result_kind kind_of(quantity wanted) {
  if (wanted < quantity::active_forces) return result_kind::equations_of_motion;
  if (wanted < quantity::kinetic_energy) return result_kind::forces;
  if (wanted < quantity::configuration_residual) return result_kind::energies;
  if (wanted < quantity::velocity_residual) return result_kind::configuration_constraints;
  if (wanted < quantity::state_matrix) return result_kind::velocity_constraints;
  return result_kind::derivatives;
}

/// Whether a result is part of the linearized equations, which are requested as a whole.
constexpr bool is_of_linearization(quantity wanted) {
  return wanted >= quantity::state_matrix && wanted <= quantity::implicit_input_matrix;
}

/// Whether a result takes weights or a direction.
constexpr bool is_to_second_order(quantity wanted) { return wanted >= quantity::weighted_gradient; }

constexpr const result_row& row_of(quantity wanted) { return results[static_cast<int>(wanted)]; }

} // namespace kanexpr::mechanics
