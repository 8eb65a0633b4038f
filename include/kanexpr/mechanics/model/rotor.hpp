#pragma once

#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/frames.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::mechanics {

/// Adds a rotor without mass that is turned by an angle about a fixed axis. Its kinetic energy is ½ J times
/// the square of the rate of the angle: the inertia of a motor that drives a joint, without the rotation of
/// the parent.
constexpr void add_rotor(mechanism& m, const name& called, int fixed_point, expression angle,
                         expression inertia) {
  const int frame = add_rotated_frame(m, called, mechanism::inertial, angle, unit(*m.g, 2));
  body rotor;
  rotor.called = called;
  rotor.center = rotor.about = fixed_point;
  rotor.frame = frame;
  rotor.mass = m.zero();
  matrix3 about_axis(*m.g);
  about_axis(2, 2) = inertia;
  rotor.inertia.add(frame, frame, about_axis);
  rotor.effective = true;
  m.bodies.push(rotor);
}

} // namespace kanexpr::mechanics
