#pragma once

#include <kanexpr/mechanics/loads/muscle_equilibrium.hpp>
#include <kanexpr/mechanics/loads/muscle_parameters.hpp>
#include <kanexpr/runtime/number_or_expression.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::runtime {

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
};

} // namespace kanexpr::runtime
