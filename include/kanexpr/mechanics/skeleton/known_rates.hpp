#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/skeleton/vector_substitution.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::mechanics {

/// Replaces the coordinate rates q̇ by the solutions of the kinematic differential equations.
class known_rates : public vector_substitution {
public:
  constexpr known_rates(const mechanism& m, const sequence<expression>& rates) : vector_substitution(*m.g) {
    for (int i = 0; i < m.coordinates.size(); ++i) replace(m.coordinate_rates[i], rates[i]);
  }
};

} // namespace kanexpr::mechanics
