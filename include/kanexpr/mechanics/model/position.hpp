#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>

/// Positions of points relative to their origins and to each other.
namespace kanexpr::mechanics {

/// The origin from which the position of a point is measured.
constexpr int origin_of(const mechanism& m, int point) {
  while (m.points[point].parent != none) point = m.points[point].parent;
  return point;
}

/// Reports two points with different origins, because origins are fixed in the inertial frame at unknown
/// positions.
constexpr base::sentence check_position(const mechanism& m, int point, int from) {
  const int origin = origin_of(m, point), other = origin_of(m, from);
  if (origin == other) return {};
  return base::sentence({"the position of ", m.points[point].called.view(), " from ",
                         m.points[from].called.view(), " is not known: they are measured from two origins, ",
                         m.points[origin].called.view(), " and ", m.points[other].called.view()});
}

/// The position of point `p` relative to its origin, as a sum over frames.
constexpr vector position_from_origin(const mechanism& m, int p) {
  vector sum;
  for (; p != none; p = m.points[p].parent) sum.add(m.points[p].offset);
  return sum;
}

/// The position of point `p` relative to `other`; both have the same origin.
constexpr vector position_from(const mechanism& m, int other, int p) {
  return position_from_origin(m, p) - position_from_origin(m, other);
}

} // namespace kanexpr::mechanics
