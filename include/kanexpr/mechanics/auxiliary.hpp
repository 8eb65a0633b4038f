#pragma once

#include <kanexpr/mechanics/skeleton.hpp>
#include <kanexpr/symbolic/substitute.hpp>

namespace kanexpr::mechanics {

/// Auxiliary speeds are zero at all times: once the partial velocities are known that bring out the forces
/// that do no work, no motion holds them any more. Kane & Levinson (1985), section 4.9.
class without_auxiliary_speeds {
public:
  constexpr explicit without_auxiliary_speeds(const mechanism& m)
      : at_rest_(*m.g), has_none_(m.auxiliary_speeds.empty()) {
    for (const expression& u : m.auxiliary_speeds) at_rest_.replace(u, m.zero());
  }

  constexpr expression in(expression e) { return has_none_ ? e : at_rest_.in(e); }
  constexpr vector in(const vector& v) {
    if (has_none_) return v;
    vector out;
    for (const vector::part& p : v.parts)
      out.parts.push({p.frame, {in(p.value.x), in(p.value.y), in(p.value.z)}});
    return out;
  }

private:
  symbolic::substitution at_rest_;
  bool has_none_ = true;
};

constexpr void drop_auxiliary_speeds(skeleton& s) {
  without_auxiliary_speeds drop(*s.model);
  for (vector& w : s.turning) w = drop.in(w);
  for (node& n : s.nodes) n.slide = drop.in(n.slide);
}

} // namespace kanexpr::mechanics
