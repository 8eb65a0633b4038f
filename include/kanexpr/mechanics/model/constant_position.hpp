#pragma once

#include <kanexpr/mechanics/model/fixed.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/position.hpp>
#include <kanexpr/mechanics/model/vector.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

/// Points whose relative position never changes.
namespace kanexpr::mechanics {

/// The lowest of the frames in which a frame is at rest because its orientation contains no coordinates.
constexpr int rigid_base(const mechanism& m, int frame) {
  const auto turns = [&](int f) {
    for (const expression& e : m.frames[f].scalars())
      if (!is_fixed(e)) return true;
    return m.frames[f].has_declared_angular_velocity();
  };
  while (frame != mechanism::inertial && !turns(frame)) frame = m.frames[frame].parent;
  return frame;
}

/// Whether a point, or one from which it is offset, has a declared velocity, which its position need not
/// follow.
constexpr bool has_declared_velocity(const mechanism& m, int point) {
  for (; point != none; point = m.points[point].parent)
    if (m.points[point].has_declared_velocity()) return true;
  return false;
}

/// The lowest frame in which the vector between two points is constant because it contains no coordinates;
/// `none` if it is not, or if a velocity is declared. (A vector may be constant for other reasons, for
/// example because it is parallel to the axis of a rotation.)
constexpr int frame_of_constant_position(const mechanism& m, int point, int from) {
  if (has_declared_velocity(m, point) || has_declared_velocity(m, from)) return none;
  int base = none;
  for (const vector::part& p : position_from(m, from, point).parts) {
    if (p.value.is_zero()) continue;
    const int frame = rigid_base(m, p.frame);
    if (!is_fixed(p.value) || (base != none && base != frame)) return none;
    base = frame;
  }
  return base == none ? mechanism::inertial : base;
}

} // namespace kanexpr::mechanics
