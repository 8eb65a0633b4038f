#pragma once

#include <kanexpr/derivation/read/value.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/motion/observe.hpp>
#include <kanexpr/mechanics/skeleton/vector_substitution.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

/// The displacement of points and axes by auxiliary speeds. Configuration constraints do not depend on
/// auxiliary speeds, because coordinates do not. Therefore they are read a second time, with each point
/// displaced along its velocity due to auxiliary speeds and each axis rotated by the corresponding angular
/// velocity. The contribution of these speeds to the rate of the constraint is linear in them.
namespace kanexpr::derivation {

/// The contribution of auxiliary speeds to a velocity.
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

/// The contribution of auxiliary speeds to the rate of an expression, given its value in the displaced
/// configuration.
constexpr expression rate_by_auxiliary(const mechanics::mechanism& m, expression displaced) {
  mechanics::without_auxiliary_speeds drop(m);
  expression rate = m.zero();
  for (const expression& u : m.auxiliary_speeds) rate += drop.in(symbolic::differentiate(displaced, u))*u;
  return rate;
}

} // namespace kanexpr::derivation
