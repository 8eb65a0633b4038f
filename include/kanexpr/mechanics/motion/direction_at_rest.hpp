#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/fixed.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/orientation.hpp>
#include <kanexpr/mechanics/motion/generic_states.hpp>
#include <kanexpr/numeric/elementary.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::mechanics {

/// Whether a unit vector that is fixed in the frame `axes` is also fixed in `other`, as the axis of a wheel
/// is fixed both in the fork and in the wheel. The derivatives of its components are evaluated numerically if
/// the expressions do not show it.
constexpr bool is_at_rest_in(const mechanism& m, const components& unit, int axes, int other) {
  const components turned = express(m, unit, axes, other);
  if (is_fixed(turned)) return true;
  sequence<expression> causes = m.coordinates;
  causes.append(m.inputs), causes.push(m.time);
  symbolic::matrix slopes(*m.g, causes.size(), 3);
  for (int j = 0; j < causes.size(); ++j)
    for (int i = 0; i < 3; ++i) slopes(j, i) = symbolic::differentiate(turned[i], causes[j]);
  for (const numbers& state : at_generic_states(slopes, &m))
    for (const double slope : state.entries)
      if (numeric::elementary::abs(slope) > 1e-9) return false;
  return true;
}

} // namespace kanexpr::mechanics
