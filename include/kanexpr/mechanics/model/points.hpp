#pragma once

#include <kanexpr/mechanics/model/mechanism.hpp>

/// The ways of saying where a point is and how it moves.
namespace kanexpr::mechanics {

/// A point that is fixed in the inertial frame.
constexpr int add_origin(mechanism& m, const name& called) {
  point p;
  p.called = called;
  return m.points.push(p);
}

/// A point at `offset` from its parent; its velocity follows from that.
constexpr int add_point(mechanism& m, const name& called, int parent, const vector& offset) {
  point p;
  p.called = called;
  p.parent = parent;
  p.offset = offset;
  return m.points.push(p);
}

/// The two-point theorem: the point and its parent are both fixed in `frame`, in whatever axes the offset is
/// given.
constexpr void fix_point(mechanism& m, int point, int frame) { m.points[point].fixed_in = frame; }

/// The velocity of a point in `reference`, given by hand; it is used in place of the derived one. In a frame
/// that turns it is the one-point theorem: the parent has to be fixed there.
constexpr void declare_velocity(mechanism& m, int point, int reference, const vector& value) {
  m.points[point].reference = reference;
  m.points[point].velocity = value;
}

} // namespace kanexpr::mechanics
