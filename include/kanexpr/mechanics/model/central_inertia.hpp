#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/inertia.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/orientation.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::mechanics {

/// The position of point `p` from its origin, as a sum over frames.
constexpr vector position_from_origin(const mechanism& m, int p) {
  vector sum;
  for (; p != none; p = m.points[p].parent) sum.add(m.points[p].offset);
  return sum;
}

/// The position of point `p` relative to `other`; both have the same origin.
constexpr vector position_from(const mechanism& m, int other, int p) {
  vector way = position_from_origin(m, p);
  way.subtract(position_from_origin(m, other));
  return way;
}

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
  if (b.about == none || b.about == b.center) return i;
  const vector r = position_from(m, b.center, b.about);
  rigid_mass point_mass(*m.g);
  point_mass.mass = -b.mass;
  return i + shifted(point_mass, express(m, r, frame)).inertia;
}

/// Adds the expressions of a body's inertia to `wanted`, and returns the vector from the mass center to the
/// reference point of the inertia.
constexpr vector collect_inertia(const mechanism& m, const body& b, sequence<expression>& wanted) {
  wanted.push(b.mass);
  for (const dyadic::part& p : b.inertia.parts)
    for (int i = 0; i < 9; ++i) wanted.push(p.value(i / 3, i % 3));
  vector from_center;
  if (b.about != none && b.about != b.center) from_center = position_from(m, b.center, b.about);
  for (const vector::part& p : from_center.parts)
    for (int i = 0; i < 3; ++i) wanted.push(p.value[i]);
  return from_center;
}

} // namespace kanexpr::mechanics
