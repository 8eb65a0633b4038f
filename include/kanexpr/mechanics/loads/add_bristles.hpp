#pragma once

#include <kanexpr/mechanics/loads/friction_law.hpp>
#include <kanexpr/mechanics/loads/loads.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::mechanics {

/// Adds the state variables of a law of friction with bristles; the load to which it belongs gives their
/// rates.
constexpr void add_bristles(const mechanism& m, loads& to, const friction_law& law) {
  for (const expression& z : law.bristles.deflections) to.state_rates.push({m.speeds.find(z), {}, {}});
}

} // namespace kanexpr::mechanics
