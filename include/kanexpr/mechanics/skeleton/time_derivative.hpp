#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::mechanics {

/// The time derivative of scalars for given rates of the coordinates and speeds; a speed without a rate is
/// treated as constant.
constexpr symbolic::differentiation time_derivative(const mechanism& m, const sequence<expression>& qdot,
                                                    const sequence<expression>& udot = {}) {
  symbolic::differentiation d(*m.g);
  d.set_rate(m.time, m.one());
  for (const prescribed_rate& p : m.prescribed_rates) d.set_rate(p.quantity, p.rate);
  for (int i = 0; i < qdot.size(); ++i) d.set_rate(m.coordinates[i], qdot[i]);
  for (int i = 0; i < udot.size(); ++i) d.set_rate(m.speeds[i], udot[i]);
  return d;
}

} // namespace kanexpr::mechanics
