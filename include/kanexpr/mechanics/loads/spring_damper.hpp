#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/loads/force_system.hpp>
#include <kanexpr/mechanics/loads/load_check.hpp>
#include <kanexpr/mechanics/loads/load_units.hpp>
#include <kanexpr/mechanics/model/central_inertia.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/position.hpp>
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
    const skeleton& s = on.skeleton_used();
    const stretch line = stretch_in(s);
    expression over_length = s.model->zero(); // force divided by distance
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

  /// ½ k (|d| − l)². Rotating the whole line does not change the energy, so the line is expressed in the axes
  /// of the first rotating frame that it involves.
  constexpr expression potential_energy(const mechanism& m) const {
    const vector line = line_in(m);
    int axes = mechanism::inertial, least = 0;
    for (const vector::part& p : line.parts) {
      const int depth = path::depth(m, p.frame);
      if (depth > 0 && (least == 0 || depth < least)) axes = p.frame, least = depth;
    }
    const components d = express(m, line, axes);
    if (length.is_zero()) return stiffness * dot(d, d) / 2;
    const expression longer = sqrt(dot(d, d)) - length;
    return stiffness * (longer * longer) / 2;
  }

  constexpr void check_with(load_check& by, int) const {
    const mechanism& m = by.mechanism_used();
    const std::string_view what = stiffness.is_zero() ? "damper" : "spring";
    if (point == against)
      return by.fail({"a ", what, " acts between point ", by.point(point), " and itself"});
    const sentence names = by.ends_of(*this);
    const int origin = origin_of(m, point), other = origin_of(m, against);
    if (origin != other)
      return by.fail({"the ", what, " between ", names.view(), " has ends measured from two origins, ",
                      by.point(origin), " and ", by.point(other), ", whose distance is not known"});
    if (line_in(m).parts.empty())
      return by.fail({"the ", what, " between ", names.view(), " has zero length in every configuration"});
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
  /// The line d between the points, in the axes in which the forces at the point deeper in the tree are
  /// formed.
  struct stretch {
    int axes = mechanism::inertial;
    components d{};
  };
  constexpr stretch stretch_in(const skeleton& s) const {
    const mechanism& m = *s.model;
    stretch line;
    int depth = 0;
    for (int p : {point, against}) {
      const int axes = s.working_axes[s.stations[s.station_of_point[p]].axes];
      if (path::depth(m, axes) > depth) line.axes = axes, depth = path::depth(m, axes);
    }
    line.d = express(m, line_in(m), line.axes);
    return line;
  }

  /// The vector from the second point to the first, without the part that both positions have in common.
  constexpr vector line_in(const mechanism& m) const {
    vector d;
    for (const vector::part& p : position_from(m, against, point).parts)
      if (!p.value.is_zero()) d.parts.push(p);
    return d;
  }

  /// The spring force divided by the length, k (1 − l/|d|). If the natural length is zero, this needs no root
  /// or division.
  constexpr expression spring_force_over_length(const components& d) const {
    return length.is_zero() ? stiffness : stiffness * (1 - length / sqrt(dot(d, d)));
  }

  /// The rate of the length divided by the length, v·d / d·d, with the relative velocity v of the points.
  constexpr expression rate_of_stretch(motion& k, const stretch& line) const {
    const skeleton& s = k.skeleton_used();
    const vector v = velocity_between(k, s.station_of_point[point], s.station_of_point[against]);
    const expression stretching = dot(line.d, express(*s.model, v, line.axes));
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

/// Adds a damper, in parallel with an existing spring if there is one.
constexpr void add_damper(sequence<spring_damper>& to, int point, int other, expression damping) {
  for (spring_damper& parallel : to)
    if (parallel.damping.is_zero() && ((parallel.point == point && parallel.against == other) ||
                                       (parallel.point == other && parallel.against == point))) {
      parallel.damping = damping;
      return;
    }
  const expression nothing{damping.owner(), graph::zero};
  to.push({point, other, nothing, nothing, damping});
}

} // namespace kanexpr::mechanics
