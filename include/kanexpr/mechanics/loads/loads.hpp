#pragma once

#include <kanexpr/mechanics/model/vector.hpp>

namespace kanexpr::mechanics {

struct force {
  int point = none;
  vector value{};
  int against = none; ///< the point that feels the opposite; none: nothing of the system does
};

struct torque {
  int frame = none;
  vector value{};
  int against = none; ///< the frame that feels the opposite
};

/// A straight massless spring and a damper beside it. They pull two points to each other with the force
/// stiffness·(distance − length) + damping·(rate of the distance).
struct spring_damper {
  int point = none;
  int other = none;
  expression stiffness{}, length{}, damping{};
};

/// A torque −damping·(ω_frame − ω_against) on what is fixed in `frame`, and its opposite on `against`.
struct torsional_damper {
  int frame = none;
  int against = none;
  expression damping{};
};

/// What acts on a mechanism, as it was given.
struct loads {
  sequence<force> forces{};
  sequence<torque> torques{};
  sequence<expression> potential_energies{}; ///< of coordinates, parameters, time and inputs; others are
                                             ///< those of gravity and of springs
  sequence<spring_damper> spring_dampers{};
  sequence<torsional_damper> torsional_dampers{};
  bool has_gravity = false;
  vector gravity{}; ///< acceleration of free fall, on every body
  bool has_lagrangian = false;
  expression lagrangian{}; ///< in place of the energies of bodies
};

/// `against`: the point that feels the opposite, if one does.
constexpr void add_force(loads& all, int point, const vector& value, int against = none) {
  all.forces.push({point, value, against});
}
/// `against`: the frame that feels the opposite, if one does.
constexpr void add_torque(loads& all, int frame, const vector& value, int against = none) {
  all.torques.push({frame, value, against});
}

/// The acceleration of free fall of every body.
constexpr void set_gravity(loads& all, const vector& acceleration) {
  all.has_gravity = true;
  all.gravity = acceleration;
}

/// A straight spring between two points, `length` long while it is at rest.
constexpr void add_spring(loads& all, int point, int other, expression stiffness, expression length) {
  all.spring_dampers.push({point, other, stiffness, length, {stiffness.owner(), graph::zero}});
}

/// A damper between two points, beside a spring that is there already.
constexpr void add_damper(loads& all, int point, int other, expression damping) {
  for (spring_damper& beside : all.spring_dampers)
    if (beside.damping.is_zero() && ((beside.point == point && beside.other == other) ||
                                     (beside.point == other && beside.other == point))) {
      beside.damping = damping;
      return;
    }
  const expression nothing{damping.owner(), graph::zero};
  all.spring_dampers.push({point, other, nothing, nothing, damping});
}

/// Between what an angle turns, which is `rest` while the spring is at rest.
constexpr void add_torsional_spring(loads& all, expression angle, expression stiffness, expression rest) {
  const expression twist = angle - rest;
  all.potential_energies.push(stiffness * (twist * twist) / 2);
}

constexpr void add_torsional_damper(loads& all, int frame, int against, expression damping) {
  all.torsional_dampers.push({frame, against, damping});
}

} // namespace kanexpr::mechanics
