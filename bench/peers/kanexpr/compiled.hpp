#pragma once

#include <kanexpr/kanexpr.hpp>

/// A compiled function behind the face that all peers have: from x = [q; u; r] to the entries of the result,
/// column by column. SYSTEM is the system, and the model's header comes by -include.
namespace peers {

using model = SYSTEM;
using eom = kanexpr::equations_of_motion<model>;

inline constexpr int coordinates = eom::coordinates, speeds = eom::speeds;
inline constexpr int states = coordinates + speeds;
inline constexpr int inputs = static_cast<int>(eom::inputs::RowsAtCompileTime);

template <class Function>
[[gnu::always_inline]] inline auto at(const Function& function, const double* x) {
  return function(Eigen::Map<const Eigen::Matrix<double, states, 1>>(x), typename eom::parameters(),
                  Eigen::Map<const Eigen::Matrix<double, inputs, 1>>(x + states));
}

} // namespace peers
