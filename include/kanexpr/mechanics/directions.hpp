#pragma once

#include <kanexpr/mechanics/skeleton.hpp>
#include <kanexpr/symbolic/differentiate.hpp>

namespace kanexpr::mechanics {

/// What a unit of one generalized speed adds to a vector that is linear in the speeds: a partial velocity or a
/// partial angular velocity.
struct direction {
  int speed = none;
  components value;
};

/// The partial derivatives of a vector by all speeds that it depends on, in the working axes of frame `f`.
constexpr sequence<direction> directions(const skeleton& s, const vector& v, int f) {
  const mechanism& m = *s.model;
  sequence<direction> out;
  if (v.is_zero()) return out;
  for (int i = 0; i < m.speeds.size(); ++i) {
    symbolic::derivation by_speed(*m.g);
    by_speed.set_rate(m.speeds[i], m.one());
    vector partial;
    for (const vector::part& p : v.parts)
      partial.add(p.frame, {by_speed.of(p.value.x), by_speed.of(p.value.y), by_speed.of(p.value.z)});
    if (!partial.is_zero()) out.push({i, express(m, partial, s.working_axes[f])});
  }
  return out;
}

} // namespace kanexpr::mechanics
