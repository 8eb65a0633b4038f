#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>

namespace kanexpr::mechanics {

/// The origin from which the position of a point is measured.
constexpr int origin_of(const mechanism& m, int point) {
  while (m.points[point].parent != none) point = m.points[point].parent;
  return point;
}

/// Reports two points with different origins: origins are fixed in the inertial frame at unknown positions.
constexpr base::sentence check_position(const mechanism& m, int point, int from) {
  const int origin = origin_of(m, point), other = origin_of(m, from);
  if (origin == other) return {};
  return base::sentence({"the position of ", m.points[point].called.view(), " from ",
                         m.points[from].called.view(), " is not known: they are measured from two origins, ",
                         m.points[origin].called.view(), " and ", m.points[other].called.view()});
}

} // namespace kanexpr::mechanics
