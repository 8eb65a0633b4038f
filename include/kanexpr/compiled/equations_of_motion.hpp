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

  /// M in M u̇ = f.
  static constexpr function<System, mechanics::quantity::mass_matrix> mass_matrix{};
  /// f in M u̇ = f.
  static constexpr function<System, mechanics::quantity::forcing> forcing{};
  /// blockdiag(E, M).
  static constexpr function<System, mechanics::quantity::mass_matrix_full> mass_matrix_full{};
  /// [q̇; f].
  static constexpr function<System, mechanics::quantity::forcing_full> forcing_full{};
  static constexpr function<System, mechanics::quantity::qdot> qdot{};
  static constexpr function<System, mechanics::quantity::udot> udot{};
  /// ẋ = [q̇; u̇].
  static constexpr function<System, mechanics::quantity::rhs> rhs{};
  /// F_r.
  static constexpr function<System, mechanics::quantity::active_forces> active_forces{};
  /// F_r*, for given rates of the speeds: f(x, p, r, a).
  static constexpr function<System, mechanics::quantity::inertia_forces> inertia_forces{};
  static constexpr function<System, mechanics::quantity::kinetic_energy> kinetic_energy{};
  static constexpr function<System, mechanics::quantity::potential_energy> potential_energy{};
  static constexpr function<System, mechanics::quantity::linear_momentum> linear_momentum{};
  static constexpr function<System, mechanics::quantity::angular_momentum> angular_momentum{};
  static constexpr function<System, mechanics::quantity::center_of_mass> center_of_mass{};

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
