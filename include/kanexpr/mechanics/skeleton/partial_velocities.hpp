#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>

namespace kanexpr::mechanics {

namespace detail {

/// The partial derivatives of a vector with respect to all speeds on which it depends, in the working axes of
/// frame `f`.
constexpr sequence<partial_velocity> partials_of(const skeleton& s, symbolic::differentiation& by_speed,
                                                 const vector& v, int f) {
  const mechanism& m = *s.model;
  sequence<partial_velocity> out;
  if (v.is_zero()) return out;
  for (int i = 0; i < m.ways(); ++i) {
    by_speed.restart();
    by_speed.set_rate(m.way(i), m.one());
    vector partial;
    for (const vector::part& p : v.parts)
      partial.add(p.frame, {by_speed.of(p.value.x), by_speed.of(p.value.y), by_speed.of(p.value.z)});
    if (!partial.is_zero()) out.push({i, express(m, partial, s.working_axes[f])});
  }
  return out;
}

} // namespace detail

/// Forms the missing partial velocities of all frames and stations. Kane & Levinson (1985), section 2.14.
constexpr void form_partial_velocities(skeleton& s) {
  symbolic::differentiation by_speed(*s.model->g);
  for (int f = s.partial_angular_velocities.size(); f < s.relative_angular_velocity.size(); ++f) {
    sequence<partial_velocity> partials;
    if (s.rigid_with[f] == f) partials = detail::partials_of(s, by_speed, s.relative_angular_velocity[f], f);
    s.partial_angular_velocities.push(partials);
  }
  for (int n = s.partial_velocities.size(); n < s.stations.size(); ++n)
    s.partial_velocities.push(
        detail::partials_of(s, by_speed, s.stations[n].relative_velocity, s.stations[n].axes));
}

} // namespace kanexpr::mechanics
