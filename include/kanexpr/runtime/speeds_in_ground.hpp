#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>

namespace kanexpr::runtime {

/// The only speed on which the angular velocity of a frame in the ground depends, if it is proportional to
/// this speed; otherwise none.
inline int only_speed_in_ground(const mechanics::skeleton& s, int frame) {
  const mechanics::mechanism& m = *s.model;
  base::sequence<mechanics::components> by_speed(m.ways(), mechanics::components(*m.g));
  for (int f = frame; f != mechanics::mechanism::inertial; f = s.turns_in[f])
    for (const mechanics::partial_velocity& v : s.partial_angular_velocities[f])
      by_speed[v.speed] += mechanics::express(m, v.value, s.working_axes[f], s.working_axes[frame]);
  int only = mechanics::none;
  for (int i = 0; i < by_speed.size(); ++i) {
    if (by_speed[i].is_zero()) continue;
    if (only != mechanics::none || !by_speed[i].is_constant()) return mechanics::none;
    only = i;
  }
  return only;
}

/// Whether a model measures the speeds of two bodies, one on the other, from the ground, as it may if they
/// rotate about parallel axes.
inline bool has_speeds_from_ground(const mechanics::skeleton& s) {
  for (int f = 1; f < s.model->frames.size(); ++f) {
    if (s.rigid_with[f] != f) continue;
    const int on = s.rigid_with[s.model->frames[f].parent];
    if (on == mechanics::mechanism::inertial) continue;
    const int own = only_speed_in_ground(s, f), other = only_speed_in_ground(s, on);
    if (own != mechanics::none && other != mechanics::none && own != other) return true;
  }
  return false;
}

} // namespace kanexpr::runtime
