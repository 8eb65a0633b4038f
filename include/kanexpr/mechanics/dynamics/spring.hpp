#pragma once

#include <kanexpr/mechanics/model/central_inertia.hpp>
#include <kanexpr/mechanics/motion/relative_motion.hpp>

/// What springs and dampers do along the line between two points.
namespace kanexpr::mechanics {

namespace detail {

/// The vector from the second point to the first, without what both positions share.
constexpr vector line_of(const mechanism& m, const spring_damper& e) {
  const vector whole = position_from_origin(m, e.point) - position_from_origin(m, e.other);
  vector d;
  for (const vector::part& p : whole.parts)
    if (!p.value.is_zero()) d.parts.push(p);
  return d;
}

} // namespace detail

/// Energy of a spring, ½ k (|d| − l)². What turns all of the line does not change it, so the line is taken in
/// the axes that come first of those that turn.
constexpr expression spring_energy(const mechanism& m, const spring_damper& e) {
  const vector line = detail::line_of(m, e);
  int axes = mechanism::inertial, least = 0;
  for (const vector::part& p : line.parts) {
    const int depth = path::depth(m, p.frame);
    if (depth > 0 && (least == 0 || depth < least)) axes = p.frame, least = depth;
  }
  const components d = express(m, line, axes);
  if (e.length.is_zero()) return e.stiffness * dot(d, d) / 2;
  const expression longer = sqrt(dot(d, d)) - e.length;
  return e.stiffness * (longer * longer) / 2;
}

/// The line d in the axes in which the forces of one of its points are formed, the last of these.
struct stretch {
  int axes = mechanism::inertial;
  components d{};
};

constexpr stretch stretch_of(const skeleton& s, const spring_damper& e) {
  const mechanism& m = *s.model;
  stretch line;
  int depth = 0;
  for (int p : {e.point, e.other}) {
    const int axes = s.working_axes[s.stations[s.station_of_point[p]].axes];
    if (path::depth(m, axes) > depth) line.axes = axes, depth = path::depth(m, axes);
  }
  line.d = express(m, detail::line_of(m, e), line.axes);
  return line;
}

/// The spring's force over its length, k (1 − l/|d|). Without natural length there is no root and no
/// division.
constexpr expression spring_pull(const spring_damper& e, const components& d) {
  return e.length.is_zero() ? e.stiffness : e.stiffness * (1 - e.length / sqrt(dot(d, d)));
}

/// The rate of the length over the length, v·d / d·d with the relative velocity v of the points.
constexpr expression rate_of_stretch(motion& k, const spring_damper& e, const stretch& line) {
  const skeleton& s = k.skeleton_used();
  const vector v = velocity_between(k, s.station_of_point[e.point], s.station_of_point[e.other]);
  return dot(line.d, express(*s.model, v, line.axes)) / dot(line.d, line.d);
}

} // namespace kanexpr::mechanics
