#pragma once

#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/inertia.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/orientation.hpp>
#include <kanexpr/mechanics/model/position.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::mechanics {

/// An inertia dyadic in the axes of `frame`. If it is given in the axes of a single frame, it is symmetric by
/// construction and its transformation costs half as much.
constexpr symmetric inertia_in(const mechanism& m, const dyadic& d, int frame) {
  const auto symmetric_of = [&](const matrix3& a) {
    symmetric i(*m.g);
    i.xx = a(0, 0), i.yy = a(1, 1), i.zz = a(2, 2);
    i.xy = a(0, 1), i.yz = a(1, 2), i.zx = a(2, 0);
    return i;
  };
  if (d.parts.size() != 1 || d.parts[0].left != d.parts[0].right) return symmetric_of(express(m, d, frame));
  return path(m, d.parts[0].left, frame).turn(symmetric_of(d.parts[0].value));
}

/// The inertia of a body about its mass center, in the axes of `frame`. The parallel-axis theorem is applied
/// if the model gives the inertia about a different point.
constexpr symmetric central_inertia(const mechanism& m, const body& b, int frame) {
  symmetric i = inertia_in(m, b.inertia, frame);
  if (!b.is_off_center()) return i;
  const vector r = position_from(m, b.center, b.about);
  rigid_mass point_mass(*m.g);
  point_mass.mass = -b.mass;
  return i + shifted(point_mass, express(m, r, frame)).inertia;
}

} // namespace kanexpr::mechanics
