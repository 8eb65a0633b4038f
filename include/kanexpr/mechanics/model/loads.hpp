#pragma once

#include <kanexpr/mechanics/model/mechanism.hpp>

/// The ways of saying what acts on a system and between its parts.
namespace kanexpr::mechanics {

/// `against`: the point that feels the opposite, if one does.
constexpr void add_force(mechanism& m, int point, const vector& value, int against = none) {
  m.forces.push({point, value, against});
}
/// `against`: the frame that feels the opposite, if one does.
constexpr void add_torque(mechanism& m, int frame, const vector& value, int against = none) {
  m.torques.push({frame, value, against});
}

/// The acceleration of free fall of every body.
constexpr void set_gravity(mechanism& m, const vector& acceleration) {
  m.has_gravity = true;
  m.gravity = acceleration;
}

/// A straight spring between two points, `length` long while it is at rest.
constexpr void add_spring(mechanism& m, int point, int other, expression stiffness, expression length) {
  m.spring_dampers.push({point, other, stiffness, length, m.zero()});
}

/// A damper between two points, beside a spring that is there already.
constexpr void add_damper(mechanism& m, int point, int other, expression damping) {
  for (spring_damper& beside : m.spring_dampers)
    if (beside.damping.is_zero() && ((beside.point == point && beside.other == other) ||
                                     (beside.point == other && beside.other == point))) {
      beside.damping = damping;
      return;
    }
  m.spring_dampers.push({point, other, m.zero(), m.zero(), damping});
}

/// Between what an angle turns, which is `rest` while the spring is at rest.
constexpr void add_torsional_spring(mechanism& m, expression angle, expression stiffness, expression rest) {
  const expression twist = angle - rest;
  m.potential_energies.push(stiffness * (twist * twist) / 2);
}

constexpr void add_torsional_damper(mechanism& m, int frame, int against, expression damping) {
  m.torsional_dampers.push({frame, against, damping});
}

} // namespace kanexpr::mechanics
