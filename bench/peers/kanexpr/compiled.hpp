#pragma once

#include <kanexpr/batch.hpp>

/// A compiled function behind the face that all peers have: from x = [q; u; r] to the entries of the result,
/// column by column. SYSTEM is the system, and the model's header comes by -include. With LANES, each entry
/// is that of so many systems, side by side.
namespace peers {

#ifndef LANES
#define LANES 1
#endif

using model = SYSTEM;
using eom = kanexpr::equations_of_motion<model>;
using linear = kanexpr::linearization<model>;
using number = std::conditional_t<LANES == 1, double, kanexpr::batch<LANES>::number>;

inline constexpr int coordinates = eom::coordinates, speeds = eom::speeds;
inline constexpr int states = coordinates + speeds;
inline constexpr int inputs = static_cast<int>(eom::inputs::RowsAtCompileTime);
inline constexpr int constraints = kanexpr::compiled::survey_of<model>.constraints;

/// M and f; of a system with constraints those of the independent speeds, with the bias of the dependent
/// rates.
inline constexpr auto mass_matrix_and_forcing = [] {
  if constexpr (constraints != 0)
    return eom::together(eom::mass_matrix, eom::forcing, eom::acceleration_bias);
  else
    return eom::together(eom::mass_matrix, eom::forcing);
}();

template <class Function>
[[gnu::always_inline]] inline auto at(const Function& function, const number* x) {
  return function(Eigen::Map<const Eigen::Matrix<number, states, 1>>(x),
                  kanexpr::parameter_values<model, number>(),
                  Eigen::Map<const Eigen::Matrix<number, inputs, 1>>(x + states));
}

} // namespace peers
