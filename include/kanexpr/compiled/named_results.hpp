#pragma once

#include <kanexpr/compiled/place.hpp>
#include <kanexpr/compiled/state.hpp>
#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/mechanics/quantity.hpp>

namespace kanexpr::compiled {

/// The results of a system by name, for every type that provides them as functions: `Function<System,
/// quantity>` is the function that returns one result.
template <template <class, auto...> class Function, class System>
struct named_results {
  using quantity = mechanics::quantity;
  using state = kanexpr::state<System>;
  using parameters = parameter_values<System>;
  using inputs = input_values<System>;
  template <quantity wanted>
  using of = Function<System, wanted>;

  static constexpr int coordinates = survey_of<System>.coordinates;
  /// The number of speeds, including state variables: in all results these are further unknowns behind the
  /// speeds, with a 1 on the diagonal of M and their rates in f.
  static constexpr int speeds = survey_of<System>.speeds;
  static constexpr int state_variables = survey_of<System>.state_variables;

  /// Whether the constraints are solved for a coordinate or speed, as chosen by the model or by the library:
  /// `eom::is_dependent(u4)`.
  template <describe::expression_of_a_model Symbol>
  static constexpr bool is_dependent(const Symbol&) {
    return survey_of<System>.dependent[place_in<System, symbols_of::state, Symbol>::place];
  }

  /// M in M u̇ = f for the independent speeds.
  static constexpr of<quantity::mass_matrix> mass_matrix{};
  /// f in M u̇ = f for the independent speeds.
  static constexpr of<quantity::forcing> forcing{};
  /// M_full in M_full [q̇; u̇] = f_full: E, M, and the differentiated constraints solved for the dependent
  /// u̇.
  static constexpr of<quantity::mass_matrix_full> mass_matrix_full{};
  /// [q̇; f; b], with b in u̇_d = A u̇_i + b.
  static constexpr of<quantity::forcing_full> forcing_full{};
  /// q̇, the rates of the coordinates.
  static constexpr of<quantity::qdot> qdot{};
  /// u̇, the rates of all speeds, independent and dependent.
  static constexpr of<quantity::udot> udot{};
  /// ẋ = [q̇; u̇].
  static constexpr of<quantity::rhs> rhs{};
  /// The generalized active forces F_r.
  static constexpr of<quantity::active_forces> active_forces{};
  /// The generalized inertia forces F_r*, at given rates of the speeds: f(x, p, r, a).
  static constexpr of<quantity::inertia_forces> inertia_forces{};
  /// F_r + F_r* for all speeds, before constraints reduce them (Kane's holonomic generalized forces), at
  /// given rates of the speeds: f(x, p, r, a). Along a motion they equal −Jᵀ λ, or zero without constraints.
  static constexpr of<quantity::unreduced_forces> unreduced_forces{};
  /// M for all speeds in M u̇ = f + Jᵀ λ, before constraints reduce them.
  static constexpr of<quantity::unreduced_mass_matrix> unreduced_mass_matrix{};
  /// f for all speeds in M u̇ = f + Jᵀ λ, before constraints reduce them.
  static constexpr of<quantity::unreduced_forcing> unreduced_forcing{};
  /// γ in J u̇ + γ = 0, the rates of the velocity constraints.
  static constexpr of<quantity::constraint_bias> constraint_bias{};
  /// The generalized forces for the independent speeds that must act in addition to the loads of the model to
  /// produce given rates of the speeds: M u̇ − f, by f(x, p, r, a).
  static constexpr of<quantity::inverse_dynamics> inverse_dynamics{};
  /// The inputs that produce given rates of the speeds: f(x, p, r, a), independent of r. Requires as many
  /// inputs as independent speeds, and forces that are linear in the inputs.
  static constexpr of<quantity::required_inputs> required_inputs{};
  /// The generalized forces for the independent speeds that balance gravity at any state, −F_r of the
  /// weights.
  static constexpr of<quantity::gravity_compensation> gravity_compensation{};
  /// C, where C u is the part of M u̇ − f that is quadratic in the speeds and Ṁ − 2C is skew-symmetric; only
  /// for systems without constraints whose speeds are the rates of coordinates.
  static constexpr of<quantity::coriolis> coriolis{};
  /// The kinetic energy in the inertial frame, a scalar, in J if the model uses SI units.
  static constexpr of<quantity::kinetic_energy> kinetic_energy{};
  /// The sum of the potential energies of gravity, springs and the loads `potential_energy`, a scalar.
  static constexpr of<quantity::potential_energy> potential_energy{};
  /// The linear momentum of all bodies, a vector in inertial axes.
  static constexpr of<quantity::linear_momentum> linear_momentum{};
  /// The angular momentum of all bodies about the origin, a vector in inertial axes.
  static constexpr of<quantity::angular_momentum> angular_momentum{};
  /// The position of the mass center of all bodies from the origin, a vector in inertial axes.
  static constexpr of<quantity::center_of_mass> center_of_mass{};
  /// ∂T/∂u_r for all speeds as if they were unconstrained, M u plus the terms that prescribed motions add;
  /// with Lagrange's method, ∂L/∂q̇_r.
  static constexpr of<quantity::generalized_momenta> generalized_momenta{};

  /// The residuals of the configuration constraints; zero if the constraints hold.
  static constexpr of<quantity::configuration_residual> configuration_residual{};
  /// The magnitudes of the terms that each residual sums.
  static constexpr of<quantity::configuration_terms> configuration_terms{};
  /// The residuals of the redundant configuration constraints.
  static constexpr of<quantity::redundant_residual> redundant_residual{};
  /// The magnitudes of the terms that are summed in each of these residuals.
  static constexpr of<quantity::redundant_terms> redundant_terms{};
  /// J in J u̇ + γ = 0, the rates of the redundant constraints.
  static constexpr of<quantity::redundant_jacobian> redundant_jacobian{};
  /// γ in J u̇ + γ = 0, the rates of the redundant constraints.
  static constexpr of<quantity::redundant_bias> redundant_bias{};
  /// The rates of the redundant configuration constraints, which vanish if the other constraints hold.
  static constexpr of<quantity::redundant_rate> redundant_rate{};
  /// The magnitudes of the terms that each of these rates sums.
  static constexpr of<quantity::redundant_rate_terms> redundant_rate_terms{};
  /// The derivatives of the configuration residuals with respect to the dependent coordinates.
  static constexpr of<quantity::configuration_jacobian_by_dependent> configuration_jacobian_by_dependent{};
  /// The derivatives of the configuration residuals with respect to all coordinates.
  static constexpr of<quantity::configuration_jacobian_by_all> configuration_jacobian_by_all{};
  /// The Newton step for the dependent coordinates, to be added to them.
  static constexpr of<quantity::configuration_step> configuration_step{};
  /// The residuals of the velocity constraints and of the rates of the configuration constraints.
  static constexpr of<quantity::velocity_residual> velocity_residual{};
  /// The magnitudes of the terms that each of these residuals sums.
  static constexpr of<quantity::velocity_terms> velocity_terms{};
  /// The residuals of the configuration constraints, followed by `velocity_residual`.
  static constexpr of<quantity::constraint_residual> constraint_residual{};
  /// J in J u + c = 0.
  static constexpr of<quantity::constraint_jacobian> constraint_jacobian{};
  /// The dependent speeds that the constraints determine from the independent ones.
  static constexpr of<quantity::dependent_speeds> dependent_speeds{};
  /// A in u̇_d = A u̇_i + b.
  static constexpr of<quantity::dependency> dependency{};
  /// b in u̇_d = A u̇_i + b.
  static constexpr of<quantity::acceleration_bias> acceleration_bias{};
  /// For each dependent speed, the determinant of the system of equations that is solved for it. The
  /// determinant vanishes and changes sign where these equations are singular.
  static constexpr of<quantity::constraint_pivots> constraint_pivots{};
  /// The constraint forces, each along the velocity that its constraint keeps at zero.
  static constexpr of<quantity::multipliers> multipliers{};
  /// The forces that keep the auxiliary speeds at zero.
  static constexpr of<quantity::noncontributing_forces> noncontributing_forces{};
  /// Another name for `noncontributing_forces`.
  static constexpr auto auxiliary_forces = noncontributing_forces;
};

} // namespace kanexpr::compiled
