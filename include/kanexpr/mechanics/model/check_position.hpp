#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>

namespace kanexpr::mechanics {

/// The origin that a point hangs on.
constexpr int origin_of(const mechanism& m, int point) {
  while (m.points[point].parent != none) point = m.points[point].parent;
  return point;
}

/// Origins are fixed in the inertial frame, and nothing says where.
constexpr sentence check_position(const mechanism& m, int point, int from) {
  const int origin = origin_of(m, point), other = origin_of(m, from);
  if (origin == other) return {};
  return sentence({"the position of ", m.points[point].called.view(), " from ", m.points[from].called.view(),
                   " is not known: they hang on two origins, ", m.points[origin].called.view(), " and ",
                   m.points[other].called.view()});
}

} // namespace kanexpr::mechanics
