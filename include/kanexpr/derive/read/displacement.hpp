#pragma once

#include <kanexpr/derive/read/value.hpp>
#include <kanexpr/mechanics/motion/observe.hpp>
#include <kanexpr/mechanics/skeleton/auxiliary.hpp>

/// Where auxiliary speeds would take points and axes. What says of places that they stay together knows
/// nothing of them, for no coordinate does; so it is read once more with each point gone along its velocity
/// by auxiliary speeds and each axis turned by such an angular velocity. What these speeds add to its rate is
/// linear in them.
namespace kanexpr::deriving {

/// Of a velocity, what auxiliary speeds bring to it.
constexpr mechanics::vector part_by_auxiliary(const mechanics::mechanism& m, const mechanics::vector& v) {
  mechanics::vector out;
  for (const mechanics::vector::part& p : v.parts) {
    components by(*m.g);
    for (int i = 0; i < 3; ++i)
      for (const expression& u : m.auxiliary_speeds) by[i] += symbolic::differentiate(p.value[i], u) * u;
    if (!by.is_zero()) out.add(p.frame, by);
  }
  return out;
}

constexpr mechanics::vector displaced_position(mechanics::motion& k, int point,
                                               const mechanics::vector& position) {
  return plus(position, part_by_auxiliary(*k.skeleton_used().model, mechanics::velocity_of_point(k, point)));
}

constexpr mechanics::vector displaced_axis(mechanics::motion& k, int frame, const mechanics::vector& axis) {
  const mechanics::mechanism& m = *k.skeleton_used().model;
  const mechanics::vector turning = part_by_auxiliary(m, mechanics::angular_velocity_of_frame(k, frame));
  if (turning.parts.empty()) return axis;
  return plus(axis, cross(m, turning, axis));
}

/// What auxiliary speeds add to the rate of something, by what it is where they have taken it.
constexpr expression rate_by_auxiliary(const mechanics::mechanism& m, expression displaced) {
  mechanics::without_auxiliary_speeds drop(m);
  expression rate = m.zero();
  for (const expression& u : m.auxiliary_speeds) rate += drop.in(symbolic::differentiate(displaced, u))*u;
  return rate;
}

} // namespace kanexpr::deriving
