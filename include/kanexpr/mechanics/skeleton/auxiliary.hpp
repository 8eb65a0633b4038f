#pragma once

#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/mechanics/skeleton/vector_substitution.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::mechanics {

/// Removes the auxiliary speeds. They are zero at all times and appear in no motion once their partial
/// velocities, which bring into evidence forces that do no work, are known. Kane & Levinson (1985), section
/// 4.9.
class without_auxiliary_speeds : public vector_substitution {
public:
  constexpr explicit without_auxiliary_speeds(const mechanism& m) : vector_substitution(*m.g) {
    for (const expression& u : m.auxiliary_speeds) replace(u, m.zero());
  }
};

constexpr void drop_auxiliary_speeds(skeleton& s) {
  without_auxiliary_speeds drop(*s.model);
  for (vector& w : s.relative_angular_velocity) w = drop.in(w);
  for (station& n : s.stations) n.relative_velocity = drop.in(n.relative_velocity);
}

} // namespace kanexpr::mechanics
