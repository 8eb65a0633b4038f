#pragma once

namespace kanexpr::mechanics {

/// What can be asked of a system. Each is a matrix of expressions; n is the number of coordinates, p of
/// speeds, m of constraints on the speeds, l of configuration constraints.
enum class quantity {
  mass_matrix,      ///< M of the independent speeds, (p−m)×(p−m)
  forcing,          ///< f with M u̇ = f, p−m
  mass_matrix_full, ///< of [q̇; u̇], (n+p)×(n+p): E, M and the differentiated constraints
  forcing_full,     ///< [q̇; f; …], n+p, with M_full [q̇; u̇] = f_full
  qdot,             ///< n
  udot,             ///< p
  rhs,              ///< [q̇; u̇], n+p
  active_forces,    ///< F_r of the independent speeds, p−m
  inertia_forces,   ///< F_r* of the independent speeds, p−m, with the symbols u̇
  unreduced_forces, ///< F_r + F_r* of all speeds before constraints reduce them, p, with the symbols u̇
  kinetic_energy,
  potential_energy,            ///< of gravity, of springs and what the model gives as one
  linear_momentum,             ///< 3, inertial axes
  angular_momentum,            ///< 3, inertial axes, about the origin
  center_of_mass,              ///< 3, inertial axes, from the origin
  configuration_residual,      ///< l
  configuration_terms,         ///< l: how large the terms are of which that is the sum
  configuration_jacobian,      ///< its derivatives by the dependent coordinates, l×l
  configuration_jacobian_full, ///< its derivatives by all coordinates, l×n
  configuration_step,          ///< of Newton's method, for the dependent coordinates, l
  velocity_residual,           ///< m: the velocity constraints, then the rates of configuration constraints
  velocity_terms,              ///< m: how large the terms are of which that is the sum
  constraint_residual,         ///< both, l+m
  constraint_jacobian,         ///< J in J u + c = 0, m×p
  dependent_speeds,            ///< u_d as the constraints give them by the independent ones, m
  dependency,                  ///< A in u̇_d = A u̇_i + b, m×(p−m)
  acceleration_bias,           ///< b in u̇_d = A u̇_i + b, m
  multipliers,                 ///< the generalized forces of the constraints: F_r + F_r* + Σ λ_j J_jr = 0, m
  auxiliary_forces,            ///< the forces that keep the auxiliary speeds zero, one for each
  state_matrix,                ///< A in δ[q̇_i; u̇_i] = A δ[q_i; u_i] + B δr, (n−l+p−m)×(n−l+p−m)
  input_matrix,                ///< B, (n−l+p−m)×s
  state_jacobian,              ///< ∂[q̇; u̇]/∂[q; u], as if nothing bound the state, (n+p)×(n+p)
  input_jacobian,              ///< ∂[q̇; u̇]/∂r, (n+p)×s
  implicit_mass_matrix,        ///< M in M δ[q̇; u̇; λ] = A δ[q_i; u_i] + B δr, (n+p+k)×(n+p+k)
  implicit_state_matrix,       ///< A, (n+p+k)×(n−l+p−m)
  implicit_input_matrix,       ///< B, (n+p+k)×s
};

} // namespace kanexpr::mechanics
