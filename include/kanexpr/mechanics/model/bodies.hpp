#pragma once

#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/inertia.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

/// Functions that add particles and rigid bodies to a mechanism.
namespace kanexpr::mechanics {

/// Returns the dyadic that has six inertia scalars in the axes of one frame; the products have the sign of I
/// = Σ m (r·r E − r r).
constexpr dyadic dyadic_of(int axes, const symmetric& scalars) {
  matrix3 value;
  for (int i = 0; i < 3; ++i) value.row[i] = {scalars(i, 0), scalars(i, 1), scalars(i, 2)};
  dyadic d;
  d.add(axes, axes, value);
  return d;
}

constexpr int add_particle(mechanism& m, const name& called, int at, expression mass) {
  body b;
  b.called = called;
  b.center = at;
  b.mass = mass;
  return m.bodies.push(b);
}

/// `about` is the reference point of the inertia; none denotes the mass center.
constexpr int add_rigid_body(mechanism& m, const name& called, int center, int frame, expression mass,
                             const dyadic& inertia, int about = none) {
  body b;
  b.called = called;
  b.center = center;
  b.frame = frame;
  b.mass = mass;
  b.inertia = inertia;
  b.about = about;
  return m.bodies.push(b);
}

} // namespace kanexpr::mechanics
