#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/symbolic/derivatives/accumulate.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::mechanics {

/// ∂V̇/∂u_r for every speed, where V is the sum of the potential energies of the model: Σ_s ∂V/∂q_s
/// ∂q̇_s/∂u_r with the rates q̇ of the kinematic equations. The generalized active force is −∂V̇/∂u_r. Kane &
/// Levinson (1985), section 5.1.
constexpr sequence<expression> potential_rates(const skeleton& s, const sequence<expression>& energies) {
  const mechanism& m = *s.model;
  symbolic::accumulation by_coordinates(*m.g, energies);
  for (const expression& energy : energies) by_coordinates.seed(energy, m.one());
  by_coordinates.run();
  symbolic::accumulation by_speeds(*m.g, s.coordinate_rates);
  for (int q = 0; q < m.coordinates.size(); ++q)
    by_speeds.seed(s.coordinate_rates[q], by_coordinates.by(m.coordinates[q]));
  by_speeds.run();
  sequence<expression> rates;
  for (const expression& u : m.speeds) rates.push(by_speeds.by(u));
  return rates;
}

} // namespace kanexpr::mechanics
