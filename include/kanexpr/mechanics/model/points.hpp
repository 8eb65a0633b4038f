#pragma once

#include <kanexpr/mechanics/model/mechanism.hpp>

/// Functions that add points to a mechanism and declare their velocities.
namespace kanexpr::mechanics {

/// Adds a point that is fixed in the inertial frame.
constexpr int add_origin(mechanism& m, const name& called) {
  point p;
  p.called = called;
  return m.points.push(p);
}

/// Adds a point at `offset` from its parent; its velocity is derived from the offset.
constexpr int add_point(mechanism& m, const name& called, int parent, const vector& offset) {
  point p;
  p.called = called;
  p.parent = parent;
  p.offset = offset;
  return m.points.push(p);
}

/// Applies the two-point theorem: the point and its parent are both fixed in `frame`, regardless of the axes
/// of the offset.
constexpr void fix_point(mechanism& m, int point, int frame) { m.points[point].fixed_in = frame; }

/// Declares the velocity of a point in `reference`, in which its parent is fixed (one-point theorem). It is
/// used instead of the derived one.
constexpr void declare_velocity_from_parent(point& p, int reference, const vector& value) {
  p.reference = reference;
  p.velocity = value;
  p.from_parent = true;
}

/// Declares the velocity of a point in `reference`, which is used instead of the derived one. In the inertial
/// frame, it is the full velocity; in any other frame, rotating or not, the one-point theorem applies.
constexpr void declare_velocity(point& p, int reference, const vector& value) {
  declare_velocity_from_parent(p, reference, value);
  p.from_parent = reference != mechanism::inertial;
}

} // namespace kanexpr::mechanics
