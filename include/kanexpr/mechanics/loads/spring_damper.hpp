#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/loads/force_system.hpp>
#include <kanexpr/mechanics/loads/load_check.hpp>
#include <kanexpr/mechanics/loads/load_units.hpp>
#include <kanexpr/mechanics/loads/observed_motion.hpp>
#include <kanexpr/mechanics/loads/segment.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/motion/relative_motion.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/units/si.hpp>

#include <string_view>

namespace kanexpr::mechanics {

/// A straight massless spring and a parallel damper. They pull two points toward each other with the force
/// stiffness·(distance − length) + damping·(rate of change of the distance).
struct spring_damper {
  int point = none;
  int against = none;
  expression stiffness{}, length{}, damping{};

  constexpr void act(force_system& on, conservative how) const {
    const mechanism& m = *on.skeleton_used().model;
    const segment::line line = between().line_in(on.skeleton_used());
    expression over_length = m.zero(); // force divided by distance
    if (how == conservative::by_forces && !stiffness.is_zero())
      over_length = spring_force_over_length(line.d);
    if (!damping.is_zero()) {
      const expression factor = on.known(damping);
      over_length += factor * rate_of_stretch(on.moving(), line);
    }
    if (over_length.is_zero()) return;
    vector force;
    force.add(line.axes, over_length * line.d);
    on.add_force(point, -force);
    on.add_force(against, force);
  }

  /// The tension, positive if the points are pulled toward each other.
  constexpr expression tension(observed_motion& on) const {
    const segment::line line = between().line_in(on.skeleton_used());
    const expression distance = sqrt(dot(line.d, line.d));
    expression pull = stiffness * (distance - length);
    if (!damping.is_zero()) pull += damping * (rate_of_stretch(on.moving(), line) * distance);
    return pull;
  }

  /// ½ k (|d| − l)².
  constexpr expression potential_energy(const mechanism& m) const {
    const components d = between().line_for_energy(m);
    if (length.is_zero()) return stiffness * dot(d, d) / 2;
    const expression longer = sqrt(dot(d, d)) - length;
    return stiffness * (longer * longer) / 2;
  }

  constexpr void check_with(load_check& by, int) const {
    const sentence found =
        between().find_mistake(by.mechanism_used(), stiffness.is_zero() ? "damper" : "spring");
    if (found) return by.fail({found.view()});
    const sentence names = by.ends_of(*this);
    by.check_constant(stiffness, "the stiffness of the spring between ", names.view());
    by.check_constant(length, "the natural length of the spring between ", names.view());
    by.check_no_speed_rates(damping, "the damping between ", names.view());
  }

  constexpr void state_units(load_units& by, int) const {
    const sentence names = by.ends_of(*this);
    by.describe({"the stiffness of the spring between ", names.view()});
    by.expect(stiffness, units::si::newton / units::si::meter);
    by.describe({"the natural length of the spring between ", names.view()});
    by.expect(length, units::si::meter);
    by.describe({"the damping between ", names.view()});
    by.expect(damping, units::si::newton * units::si::second / units::si::meter);
  }

private:
  constexpr segment between() const { return {point, against}; }

  /// The spring force divided by the length, k (1 − l/|d|). If the natural length is zero, this needs no root
  /// or division.
  constexpr expression spring_force_over_length(const components& d) const {
    return length.is_zero() ? stiffness : stiffness * (1 - length / sqrt(dot(d, d)));
  }

  /// The rate of the length divided by the length, v·d / d·d, with the relative velocity v of the points.
  constexpr expression rate_of_stretch(motion& k, const segment::line& line) const {
    const expression stretching = between().stretching(k, line);
    return stretching / dot(line.d, line.d);
  }
};

/// A torque −damping·(ω_frame − ω_against) on the body fixed in `frame`, and its opposite on `against`.
struct torsional_damper {
  int frame = none;
  int against = none;
  expression damping{};

  constexpr void act(force_system& on, conservative) const {
    const expression factor = -on.known(damping);
    on.add_torque(frame, against, factor * angular_velocity_between(on.skeleton_used(), frame, against));
  }

  constexpr void check_with(load_check& by, int) const {
    if (frame == against) by.fail({"a torsional damper acts between frame ", by.frame(frame), " and itself"});
    by.check_no_speed_rates(damping, "the torsional damping between ", by.ends_of(*this).view());
  }

  constexpr void state_units(load_units& by, int) const {
    by.describe({"the torsional damping between ", by.ends_of(*this).view()});
    by.expect(damping, units::si::newton * units::si::meter * units::si::second / units::si::radian);
  }
};

constexpr void add_spring(sequence<spring_damper>& to, int point, int other, expression stiffness,
                          expression length) {
  to.push({point, other, stiffness, length, {stiffness.owner(), graph::zero}});
}

constexpr spring_damper damper_alone(int point, int other, expression damping) {
  const expression nothing{damping.owner(), graph::zero};
  return {point, other, nothing, nothing, damping};
}

/// Adds a damper, in parallel with an existing spring if there is one.
constexpr void add_damper(sequence<spring_damper>& to, int point, int other, expression damping) {
  for (spring_damper& parallel : to)
    if (parallel.damping.is_zero() && ((parallel.point == point && parallel.against == other) ||
                                       (parallel.point == other && parallel.against == point))) {
      parallel.damping = damping;
      return;
    }
  to.push(damper_alone(point, other, damping));
}

} // namespace kanexpr::mechanics
