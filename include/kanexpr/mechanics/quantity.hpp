#pragma once

#include <string_view>

namespace kanexpr::mechanics {

/// The results available for a system. Each is a matrix of expressions; n is the number of coordinates, p the
/// number of speeds, m the number of constraints on the speeds, and l the number of configuration
/// constraints.
enum class quantity : unsigned char {
  mass_matrix,           ///< M of the independent speeds, (p−m)×(p−m)
  forcing,               ///< f in M u̇ = f, p−m
  mass_matrix_full,      ///< M_full of [q̇; u̇], (n+p)×(n+p): E, M and the differentiated constraints
  forcing_full,          ///< [q̇; f; …], n+p, with M_full [q̇; u̇] = f_full
  qdot,                  ///< q̇, n
  udot,                  ///< u̇ of all speeds, p
  rhs,                   ///< [q̇; u̇], n+p
  active_forces,         ///< F_r of the independent speeds, p−m
  inertia_forces,        ///< F_r* of the independent speeds, p−m, with the symbols u̇
  unreduced_forces,      ///< F_r + F_r* of all speeds before constraints reduce them, p, with the symbols u̇
  unreduced_mass_matrix, ///< M of all speeds before constraints reduce it, p×p
  unreduced_forcing,     ///< f of all speeds before constraints reduce it, p
  constraint_bias,       ///< γ in J u̇ + γ = 0, m
  inverse_dynamics,      ///< additional forces required on the independent speeds, p−m, with the symbols u̇
  required_inputs,       ///< the inputs that produce u̇, s = p−m, with the symbols u̇
  gravity_compensation,  ///< forces on the independent speeds that balance gravity, p−m
  load_compensation,     ///< forces on the independent speeds that balance all other loads, p−m
  regressor,             ///< Y in τ = Y π + τ_0, the inverse dynamics in the b inertial parameters, (p−m)×b
  inertial_parameters,   ///< π with the values of the model, b
  coriolis,              ///< C with Ṁ − 2C skew-symmetric, if the speeds are coordinate rates, p×p
  kinetic_energy,
  potential_energy,                    ///< the energy of gravity, springs and given potential energies
  linear_momentum,                     ///< 3, inertial axes
  angular_momentum,                    ///< 3, inertial axes, about the origin
  center_of_mass,                      ///< 3, inertial axes, from the origin
  generalized_momenta,                 ///< ∂T/∂u, or ∂L/∂q̇, of all speeds before constraints reduce them, p
  configuration_residual,              ///< values of the configuration constraints, l
  configuration_terms,                 ///< magnitude of the terms of this residual, l
  redundant_residual,                  ///< residual of the redundant constraints
  redundant_terms,                     ///< magnitude of the terms of this residual
  redundant_jacobian,                  ///< J of their rates, a column for each speed
  redundant_bias,                      ///< their γ in J u̇ + γ = 0
  redundant_rate,                      ///< the rates of the redundant constraints
  redundant_rate_terms,                ///< magnitude of the terms of these rates
  configuration_jacobian_by_dependent, ///< derivatives of the residual with respect to the dependent
                                       ///< coordinates, l×l
  configuration_jacobian_by_all,       ///< derivatives of the residual with respect to all coordinates, l×n
  configuration_step,                  ///< Newton step of the dependent coordinates, l
  velocity_residual,      ///< residual of the velocity constraints, then of the rates of configuration
                          ///< constraints, m
  velocity_terms,         ///< magnitude of the terms of this residual, m
  constraint_residual,    ///< both residuals, l+m
  constraint_jacobian,    ///< J in J u + c = 0, m×p
  dependent_speeds,       ///< u_d in terms of the independent speeds, m
  dependency,             ///< A in u̇_d = A u̇_i + b, m×(p−m)
  acceleration_bias,      ///< b in u̇_d = A u̇_i + b, m
  constraint_pivots,      ///< the determinants of the blocks in which dependent speeds are solved, m
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
  bool is_of_bodies = false;      ///< not available if the model specifies its Lagrangian as a whole
  bool holds_speed_rates = false; ///< depends on the symbols u̇, which are passed to its function
  bool takes_weights = false;     ///< depends on the weights λ of ẋ, which are passed to its function
  bool takes_direction = false;   ///< depends on the direction v of z, which is passed to its function
};

inline constexpr result_row results[]{
    {quantity::mass_matrix, "mass_matrix", extent_by::independent_speeds, extent_by::independent_speeds,
     stage::equations},
    {quantity::forcing, "forcing", extent_by::independent_speeds, extent_by::one, stage::equations},
    {quantity::mass_matrix_full, "mass_matrix_full", extent_by::coordinates_and_speeds,
     extent_by::coordinates_and_speeds, stage::equations},
    {quantity::forcing_full, "forcing_full", extent_by::coordinates_and_speeds, extent_by::one,
     stage::equations},
    {quantity::qdot, "qdot", extent_by::coordinates, extent_by::one, stage::constrained},
    {quantity::udot, "udot", extent_by::speeds, extent_by::one, stage::equations},
    {quantity::rhs, "rhs", extent_by::coordinates_and_speeds, extent_by::one, stage::equations},
    {quantity::active_forces, "active_forces", extent_by::independent_speeds, extent_by::one,
     stage::equations},
    {quantity::inertia_forces, "inertia_forces", extent_by::independent_speeds, extent_by::one,
     stage::equations, false, true},
    {quantity::unreduced_forces, "unreduced_forces", extent_by::speeds, extent_by::one, stage::equations,
     false, true},
    {quantity::unreduced_mass_matrix, "unreduced_mass_matrix", extent_by::speeds, extent_by::speeds,
     stage::equations},
    {quantity::unreduced_forcing, "unreduced_forcing", extent_by::speeds, extent_by::one, stage::equations},
    {quantity::constraint_bias, "constraint_bias", extent_by::speed_constraints, extent_by::one,
     stage::equations},
    {quantity::inverse_dynamics, "inverse_dynamics", extent_by::independent_speeds, extent_by::one,
     stage::constrained, false, true},
    {quantity::required_inputs, "required_inputs", extent_by::inputs, extent_by::one, stage::constrained,
     false, true},
    {quantity::gravity_compensation, "gravity_compensation", extent_by::independent_speeds, extent_by::one,
     stage::constrained, true},
    {quantity::load_compensation, "load_compensation", extent_by::independent_speeds, extent_by::one,
     stage::constrained},
    {quantity::regressor, "regressor", extent_by::independent_speeds, extent_by::inertial_parameters,
     stage::constrained, true, true},
    {quantity::inertial_parameters, "inertial_parameters", extent_by::inertial_parameters, extent_by::one,
     stage::constrained, true},
    {quantity::coriolis, "coriolis", extent_by::speeds, extent_by::speeds, stage::constrained},
    {quantity::kinetic_energy, "kinetic_energy", extent_by::scalar, extent_by::scalar, stage::constrained,
     true},
    {quantity::potential_energy, "potential_energy", extent_by::scalar, extent_by::scalar, stage::constrained,
     true},
    {quantity::linear_momentum, "linear_momentum", extent_by::three, extent_by::one, stage::constrained,
     true},
    {quantity::angular_momentum, "angular_momentum", extent_by::three, extent_by::one, stage::constrained,
     true},
    {quantity::center_of_mass, "center_of_mass", extent_by::three, extent_by::one, stage::constrained, true},
    {quantity::generalized_momenta, "generalized_momenta", extent_by::speeds, extent_by::one,
     stage::constrained},
    {quantity::configuration_residual, "configuration_residual", extent_by::configuration_constraints,
     extent_by::one, stage::constrained},
    {quantity::configuration_terms, "configuration_terms", extent_by::configuration_constraints,
     extent_by::one, stage::constrained},
    {quantity::redundant_residual, "redundant_residual", extent_by::redundant_constraints, extent_by::one,
     stage::constrained},
    {quantity::redundant_terms, "redundant_terms", extent_by::redundant_constraints, extent_by::one,
     stage::constrained},
    {quantity::redundant_jacobian, "redundant_jacobian", extent_by::redundant_constraints, extent_by::speeds,
     stage::constrained},
    {quantity::redundant_bias, "redundant_bias", extent_by::redundant_constraints, extent_by::one,
     stage::equations},
    {quantity::redundant_rate, "redundant_rate", extent_by::redundant_constraints, extent_by::one,
     stage::constrained},
    {quantity::redundant_rate_terms, "redundant_rate_terms", extent_by::redundant_constraints, extent_by::one,
     stage::constrained},
    {quantity::configuration_jacobian_by_dependent, "configuration_jacobian_by_dependent",
     extent_by::configuration_constraints, extent_by::configuration_constraints, stage::constrained},
    {quantity::configuration_jacobian_by_all, "configuration_jacobian_by_all",
     extent_by::configuration_constraints, extent_by::coordinates, stage::constrained},
    {quantity::configuration_step, "configuration_step", extent_by::configuration_constraints, extent_by::one,
     stage::constrained},
    {quantity::velocity_residual, "velocity_residual", extent_by::speed_constraints, extent_by::one,
     stage::constrained},
    {quantity::velocity_terms, "velocity_terms", extent_by::speed_constraints, extent_by::one,
     stage::constrained},
    {quantity::constraint_residual, "constraint_residual", extent_by::all_constraints, extent_by::one,
     stage::constrained},
    {quantity::constraint_jacobian, "constraint_jacobian", extent_by::speed_constraints, extent_by::speeds,
     stage::constrained},
    {quantity::dependent_speeds, "dependent_speeds", extent_by::speed_constraints, extent_by::one,
     stage::equations},
    {quantity::dependency, "dependency", extent_by::speed_constraints, extent_by::independent_speeds,
     stage::equations},
    {quantity::acceleration_bias, "acceleration_bias", extent_by::speed_constraints, extent_by::one,
     stage::equations},
    {quantity::constraint_pivots, "constraint_pivots", extent_by::speed_constraints, extent_by::one,
     stage::equations},
    {quantity::multipliers, "multipliers", extent_by::speed_constraints, extent_by::one, stage::equations},
    {quantity::noncontributing_forces, "noncontributing_forces", extent_by::auxiliary_speeds, extent_by::one,
     stage::equations},
    {quantity::state_matrix, "explicit_form", extent_by::independent_states, extent_by::independent_states,
     stage::linearized},
    {quantity::input_matrix, "explicit_form", extent_by::independent_states, extent_by::inputs,
     stage::linearized},
    {quantity::state_jacobian, "jacobian", extent_by::coordinates_and_speeds,
     extent_by::coordinates_and_speeds, stage::equations},
    {quantity::input_jacobian, "jacobian", extent_by::coordinates_and_speeds, extent_by::inputs,
     stage::equations},
    {quantity::implicit_mass_matrix, "implicit_form", extent_by::unknowns, extent_by::unknowns,
     stage::equations},
    {quantity::implicit_state_matrix, "implicit_form", extent_by::unknowns, extent_by::independent_states,
     stage::equations},
    {quantity::implicit_input_matrix, "implicit_form", extent_by::unknowns, extent_by::inputs,
     stage::equations},
    {quantity::weighted_gradient, "gradient", extent_by::state_and_inputs, extent_by::one, stage::equations,
     false, false, true},
    {quantity::directional_derivative, "directional_derivative", extent_by::coordinates_and_speeds,
     extent_by::one, stage::equations, false, false, false, true},
    {quantity::weighted_hessian, "hessian", extent_by::state_and_inputs, extent_by::state_and_inputs,
     stage::equations, false, false, true},
    {quantity::weighted_hessian_product, "hessian_product", extent_by::state_and_inputs, extent_by::one,
     stage::equations, false, false, true, true},
};

/// The rows are in the order of the quantities.
static_assert([] {
  int next = 0;
  for (const result_row& row : results)
    if (static_cast<int>(row.is) != next++) return false;
  return true;
}());

/// Whether a result is part of the linearized equations, which are requested as a whole.
constexpr bool is_of_linearization(quantity wanted) {
  return wanted >= quantity::state_matrix && wanted <= quantity::implicit_input_matrix;
}

/// Whether a result takes weights or a direction.
constexpr bool is_to_second_order(quantity wanted) { return wanted >= quantity::weighted_gradient; }

constexpr const result_row& row_of(quantity wanted) { return results[static_cast<int>(wanted)]; }

} // namespace kanexpr::mechanics
