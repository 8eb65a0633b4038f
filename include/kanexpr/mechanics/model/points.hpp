#pragma once

#include <kanexpr/mechanics/model/mechanism.hpp>

/// Functions that add points to a mechanism and declare their velocities.
namespace kanexpr::mechanics {

/// A point that is fixed in the inertial frame.
constexpr int add_origin(mechanism& m, const name& called) {
  point p;
  p.called = called;
  return m.points.push(p);
}

/// A point at `offset` from its parent; its velocity is derived from the offset.
constexpr int add_point(mechanism& m, const name& called, int parent, const vector& offset) {
  point p;
  p.called = called;
  p.parent = parent;
  p.offset = offset;
  return m.points.push(p);
}

/// The two-point theorem: the point and its parent are both fixed in `frame`, whatever the axes of the
/// offset.
constexpr void fix_point(mechanism& m, int point, int frame) { m.points[point].fixed_in = frame; }

/// The one-point theorem: the velocity of a point in `reference`, in which its parent is fixed. It is used
/// instead of the derived one.
constexpr void declare_velocity_from_parent(point& p, int reference, const vector& value) {
  p.reference = reference;
  p.velocity = value;
  p.from_parent = true;
}

/// The velocity of a point in `reference`, used instead of the derived one: as given in the inertial frame,
/// and by the one-point theorem in any other frame, whether it rotates or not.
constexpr void declare_velocity(point& p, int reference, const vector& value) {
  declare_velocity_from_parent(p, reference, value);
  p.from_parent = reference != mechanism::inertial;
}

} // namespace kanexpr::mechanics
