#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/symbolic/derivatives/dependence.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>

namespace kanexpr::mechanics {

namespace detail {

constexpr void add_nodes(const vector& v, sequence<int>& nodes) {
  for (const vector::part& p : v.parts)
    for (int i = 0; i < 3; ++i)
      if (!p.value[i].is_zero()) nodes.push(p.value[i].node());
}

/// The partial derivatives of a vector with respect to all speeds on which it depends, in the working axes of
/// frame `f`.
constexpr sequence<partial_velocity> partials_of(const skeleton& s, const symbolic::dependence& on_speeds,
                                                 const vector& v, int f) {
  const mechanism& m = *s.model;
  sequence<partial_velocity> out;
  sequence<int> nodes;
  add_nodes(v, nodes);
  for (int i : on_speeds.directions_of(nodes)) {
    symbolic::differentiation by_speed(*m.g);
    by_speed.set_rate(m.way(i), m.one());
    by_speed.skip_unchanged(on_speeds, i);
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
  const mechanism& m = *s.model;
  const int frames = s.partial_angular_velocities.size(), stations = s.partial_velocities.size();
  sequence<int> nodes;
  for (int f = frames; f < s.relative_angular_velocity.size(); ++f)
    if (s.rigid_with[f] == f) detail::add_nodes(s.relative_angular_velocity[f], nodes);
  for (int n = stations; n < s.stations.size(); ++n)
    detail::add_nodes(s.stations[n].relative_velocity, nodes);
  symbolic::dependence on_speeds(*m.g, nodes, m.ways());
  for (int i = 0; i < m.ways(); ++i) on_speeds.mark(m.way(i).node(), i);
  on_speeds.spread();
  for (int f = frames; f < s.relative_angular_velocity.size(); ++f) {
    sequence<partial_velocity> partials;
    if (s.rigid_with[f] == f) partials = detail::partials_of(s, on_speeds, s.relative_angular_velocity[f], f);
    s.partial_angular_velocities.push(partials);
  }
  for (int n = stations; n < s.stations.size(); ++n)
    s.partial_velocities.push(
        detail::partials_of(s, on_speeds, s.stations[n].relative_velocity, s.stations[n].axes));
}

} // namespace kanexpr::mechanics
