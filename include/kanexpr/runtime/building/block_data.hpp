#pragma once

#include <kanexpr/mechanics/loads/muscle_equilibrium.hpp>
#include <kanexpr/mechanics/loads/muscle_parameters.hpp>
#include <kanexpr/runtime/building/number_or_expression.hpp>
#include <kanexpr/runtime/building/pulling_load.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <optional>

namespace kanexpr::runtime {

/// A DC motor in a builder; see `dc_motor<Joint, …>`. The function `rotor` adds the inertia of its rotor.
struct dc_motor_data {
  /// Lets the resistance R (1 + α θ) grow with the heating θ of the winding.
  struct winding_data {
    number_or_expression temperature_coefficient; ///< α
    number_or_expression heat_capacity;
    number_or_expression thermal_resistance;
  };

  number_or_expression voltage, resistance, inductance, torque_constant;
  number_or_expression gear_ratio = 1.0; ///< turns of the rotor per turn of the joint
  number_or_expression friction = 0.0;   ///< the viscous friction of the rotor
  std::optional<winding_data> winding{};
};

/// The state variables of a DC motor in a builder, and its torque.
struct dc_motor_states {
  symbolic::expression current{};
  symbolic::expression heating{}; ///< not given without `winding`
  symbolic::expression torque{};  ///< on the joint, to be applied by `torque_between`
};

/// The parameters of a muscle in a builder: `{.peak_isometric_force = F, .optimal_fiber_length = 0.1,
/// .tendon_slack_length = 0.2}`.
using muscle_data =
    muscle_parameters<number_or_expression, number_or_expression, number_or_expression, number_or_expression,
                      number_or_expression, number_or_expression, number_or_expression, number_or_expression,
                      number_or_expression, number_or_expression>;

/// The state variables of a muscle in a builder.
struct muscle_states {
  symbolic::expression activation{};   ///< the excitation if there are no activation dynamics
  symbolic::expression tendon_state{}; ///< not given with a rigid tendon
  pulling_load load{};                 ///< for `tension_of`
};

} // namespace kanexpr::runtime
