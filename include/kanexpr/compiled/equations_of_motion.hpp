#pragma once

#include <kanexpr/compiled/function.hpp>

namespace kanexpr {

/// The equations of motion of a system as compiled functions: `equations_of_motion<System>::mass_matrix(x,
/// p)`.
template <class System>
struct equations_of_motion {
  using state = kanexpr::state<System>;
  using parameters = parameter_values<System>;
  using inputs = input_values<System>;

  static constexpr int coordinates = compiled::survey_of<System>.coordinates;
  static constexpr int speeds = compiled::survey_of<System>.speeds;

  /// Whether the constraints are solved for a coordinate or speed, by the choice of the model or of the
  /// library: `eom::is_dependent(u4)`.
  template <text called, int index>
  static constexpr bool is_dependent(const coordinate<called, index>&) {
    return compiled::survey_of<System>.dependent[compiled::placed<System, symbolic::symbol_kind::coordinate,
                                                                  called, index>::place];
  }
  template <text called, int index>
  static constexpr bool is_dependent(const speed<called, index>&) {
    return compiled::survey_of<System>.dependent
        [coordinates + compiled::placed<System, symbolic::symbol_kind::speed, called, index>::place];
  }

  template <text called, int index>
  static constexpr bool is_dependent(const coordinate_rate<called, index>&) {
    return compiled::survey_of<System>.dependent
        [coordinates +
         compiled::placed<System, symbolic::symbol_kind::coordinate_rate, called, index>::place];
  }

  /// M in M u̇ = f of the independent speeds.
  static constexpr function<System, mechanics::quantity::mass_matrix> mass_matrix{};
  /// f in M u̇ = f of the independent speeds.
  static constexpr function<System, mechanics::quantity::forcing> forcing{};
  /// M_full in M_full [q̇; u̇] = f_full: E, M, and the differentiated constraints solved for the dependent u̇.
  static constexpr function<System, mechanics::quantity::mass_matrix_full> mass_matrix_full{};
  /// [q̇; f; b], with b in u̇_d = A u̇_i + b.
  static constexpr function<System, mechanics::quantity::forcing_full> forcing_full{};
  static constexpr function<System, mechanics::quantity::qdot> qdot{};
  static constexpr function<System, mechanics::quantity::udot> udot{};
  /// ẋ = [q̇; u̇].
  static constexpr function<System, mechanics::quantity::rhs> rhs{};
  /// F_r.
  static constexpr function<System, mechanics::quantity::active_forces> active_forces{};
  /// F_r*, for given rates of the speeds: f(x, p, r, a).
  static constexpr function<System, mechanics::quantity::inertia_forces> inertia_forces{};
  /// F_r + F_r* of all speeds, before constraints reduce them (Kane's holonomic generalized forces), for
  /// given rates of the speeds: f(x, p, r, a). In motion they leave −Jᵀ λ, and zero without constraints.
  static constexpr function<System, mechanics::quantity::unreduced_forces> unreduced_forces{};
  static constexpr function<System, mechanics::quantity::kinetic_energy> kinetic_energy{};
  static constexpr function<System, mechanics::quantity::potential_energy> potential_energy{};
  static constexpr function<System, mechanics::quantity::linear_momentum> linear_momentum{};
  static constexpr function<System, mechanics::quantity::angular_momentum> angular_momentum{};
  static constexpr function<System, mechanics::quantity::center_of_mass> center_of_mass{};

  /// What the configuration constraints leave, zero where they hold.
  static constexpr function<System, mechanics::quantity::configuration_residual> configuration_residual{};
  /// How large the terms are of which each of that is the sum.
  static constexpr function<System, mechanics::quantity::configuration_terms> configuration_terms{};
  /// Its derivatives by the dependent coordinates.
  static constexpr function<System, mechanics::quantity::configuration_jacobian_by_dependent>
      configuration_jacobian_by_dependent{};
  /// Its derivatives by all coordinates.
  static constexpr function<System, mechanics::quantity::configuration_jacobian_by_all>
      configuration_jacobian_by_all{};
  /// The step of Newton's method for the dependent coordinates, to be added to them.
  static constexpr function<System, mechanics::quantity::configuration_step> configuration_step{};
  /// What the velocity constraints and the rates of the configuration constraints leave.
  static constexpr function<System, mechanics::quantity::velocity_residual> velocity_residual{};
  static constexpr function<System, mechanics::quantity::velocity_terms> velocity_terms{};
  /// Both residuals, those of configurations first.
  static constexpr function<System, mechanics::quantity::constraint_residual> constraint_residual{};
  /// J in J u + c = 0.
  static constexpr function<System, mechanics::quantity::constraint_jacobian> constraint_jacobian{};
  /// The dependent speeds as the constraints give them by the independent ones.
  static constexpr function<System, mechanics::quantity::dependent_speeds> dependent_speeds{};
  /// A in u̇_d = A u̇_i + b.
  static constexpr function<System, mechanics::quantity::dependency> dependency{};
  /// b in u̇_d = A u̇_i + b.
  static constexpr function<System, mechanics::quantity::acceleration_bias> acceleration_bias{};
  /// The forces of the constraints, each along the direction in which it holds a velocity zero.
  static constexpr function<System, mechanics::quantity::multipliers> multipliers{};
  /// The forces that keep the auxiliary speeds zero.
  static constexpr function<System, mechanics::quantity::noncontributing_forces> noncontributing_forces{};
  /// The same by another name.
  static constexpr auto auxiliary_forces = noncontributing_forces;

  /// Several results of one call, which share their work: `auto [M, f] = together(mass_matrix, forcing)(x,
  /// p);`
  template <auto... first, auto... second, class... More>
  static constexpr auto together(function<System, first...>, function<System, second...>, More... more) {
    if constexpr (sizeof...(More) == 0)
      return function<System, first..., second...>{};
    else
      return together(function<System, first..., second...>{}, more...);
  }

  /// Operations of one call of a function: `static_assert(eom::cost(eom::mass_matrix).multiplications <=
  /// 10);`
  template <auto... wanted>
  static constexpr symbolic::cost cost(function<System, wanted...> f) {
    return f.cost();
  }
};

} // namespace kanexpr
