#pragma once

#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/motion/motion.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>

/// The relative motion of frames and points, formed only from the path between them.
namespace kanexpr::mechanics {

/// The angular velocity of one frame minus that of another.
constexpr vector angular_velocity_between(const skeleton& s, int frame, int other) {
  const auto depth = [&](int f) {
    int steps = 0;
    for (; f != mechanism::inertial; f = s.turns_in[f]) ++steps;
    return steps;
  };
  int a = s.rigid_with[frame], b = s.rigid_with[other];
  int above_a = depth(a), above_b = depth(b);
  vector w;
  while (a != b)
    if (above_a >= above_b) {
      w.add(s.relative_angular_velocity[a]);
      a = s.turns_in[a], --above_a;
    } else {
      w.subtract(s.relative_angular_velocity[b]);
      b = s.turns_in[b], --above_b;
    }
  return w;
}

namespace detail {

/// The velocity of a station relative to the station from which it is measured.
constexpr vector relative_velocity_of(motion& k, int n) {
  const skeleton& s = k.skeleton_used();
  const station& at = s.stations[n];
  vector v = at.relative_velocity;
  if (at.absolute) return v;
  const components w = k.angular_velocity(at.frame), r = s.offset_in_working_axes(n);
  v.add(s.working_axes[at.frame], cross(w, r));
  return v;
}

} // namespace detail

/// The velocity of one station minus that of another.
constexpr vector velocity_between(motion& k, int station, int other) {
  const skeleton& s = k.skeleton_used();
  const auto below = [&](int n) { return s.stations[n].absolute ? none : s.stations[n].parent; };
  const auto depth = [&](int n) {
    int steps = 0;
    for (; n != none; n = below(n)) ++steps;
    return steps;
  };
  int above_a = depth(station), above_b = depth(other);
  vector v;
  for (int a = station, b = other; a != b;)
    if (above_a >= above_b) {
      v.add(detail::relative_velocity_of(k, a));
      a = below(a), --above_a;
    } else {
      v.subtract(detail::relative_velocity_of(k, b));
      b = below(b), --above_b;
    }
  return v;
}

} // namespace kanexpr::mechanics
