#pragma once

#include <kanexpr/mechanics/inertia.hpp>
#include <kanexpr/mechanics/orientation.hpp>

namespace kanexpr::mechanics {

/// The position of point `p` from its origin, as a sum over frames.
constexpr vector position_from_origin(const mechanism& m, int p) {
  vector sum;
  for (; p != none; p = m.points[p].parent) sum.add(m.points[p].offset);
  return sum;
}

/// A body's inertia about its mass centre, in the axes of `frame`; the parallel-axis theorem is applied where
/// the model gives it about another point.
constexpr symmetric central_inertia(const mechanism& m, const body& b, int frame) {
  const matrix3 given = express(m, b.inertia, frame);
  symmetric i(*m.g);
  i.xx = given(0, 0), i.yy = given(1, 1), i.zz = given(2, 2);
  i.xy = given(0, 1), i.yz = given(1, 2), i.zx = given(2, 0);
  if (b.about == none || b.about == b.center) return i;
  vector r = position_from_origin(m, b.about);
  r.subtract(position_from_origin(m, b.center));
  rigid_mass point_mass(*m.g);
  point_mass.mass = -b.mass;
  return i + shifted(point_mass, express(m, r, frame)).inertia;
}

} // namespace kanexpr::mechanics
