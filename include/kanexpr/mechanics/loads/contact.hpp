#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/loads/contact_geometry.hpp>
#include <kanexpr/mechanics/loads/contact_law.hpp>
#include <kanexpr/mechanics/loads/contact_shapes.hpp>
#include <kanexpr/mechanics/loads/force_system.hpp>
#include <kanexpr/mechanics/loads/friction_law.hpp>
#include <kanexpr/mechanics/loads/load_check.hpp>
#include <kanexpr/mechanics/loads/load_units.hpp>
#include <kanexpr/mechanics/loads/observed_motion.hpp>
#include <kanexpr/mechanics/loads/state_rate.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/constant_position.hpp>
#include <kanexpr/mechanics/model/fixed.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/orientation.hpp>
#include <kanexpr/mechanics/model/position.hpp>
#include <kanexpr/mechanics/motion/direction_at_rest.hpp>
#include <kanexpr/mechanics/motion/motion.hpp>
#include <kanexpr/mechanics/motion/relative_motion.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/functions.hpp>
#include <kanexpr/units/si.hpp>

#include <string_view>

namespace kanexpr::mechanics {

/// The resistance to rolling or spinning: a torque −b N ω/√(ω² + ωₛ²) against the part ω of the relative
/// angular velocity that is parallel to the tangent plane, or normal to it.
struct rotation_resistance {
  expression lever{};            ///< b, a length
  expression angular_velocity{}; ///< ωₛ, over which rest is smoothed

  constexpr explicit operator bool() const { return lever.is_given(); }
};

/// A direction along which the friction differs from that across it, such as the blade of a skate. With the
/// slip v and the stretch S v, in which the part of v along the direction is multiplied by the ratio, the
/// friction is S F(S v) instead of F(v). By Coulomb's law, the friction along the direction is that across it
/// times the ratio, and its limit is an ellipse. Its power is that of F at the slip S v.
struct friction_direction {
  components unit{}; ///< in the axes of `frame`
  int frame = none;
  expression ratio{}; ///< of the friction along the direction to that across it

  constexpr explicit operator bool() const { return ratio.is_given(); }
};

/// A contact between two bodies, which is open if they do not touch. The normal force and the friction act at
/// the contact, on the first body and, with opposite sign, on the second.
struct contact {
  contact_geometry between{};
  contact_law law{};
  friction_law friction{};
  rotation_resistance rolling{}, spinning{};
  friction_direction direction{};

private:
  /// The normal force that belongs to an elastic force and a relative velocity.
  constexpr expression pressed_by(expression elastic, const touching& at, const components& slip) const {
    const expression approach = -dot(at.push, slip);
    return elastic * law.dissipation(approach);
  }

  constexpr components in_tangent_plane(const components& v, const touching& at) const {
    return v - dot(at.normal, v) * at.normal;
  }

  /// S v of a vector in the tangent plane.
  constexpr components stretched(const components& v, const touching& at, const mechanism& m) const {
    if (!direction) return v;
    vector given;
    given.add(direction.frame, direction.unit);
    const components along = in_tangent_plane(express(m, given, between.other), at);
    const expression part = dot(along, v) / dot(along, along), excess = direction.ratio - 1;
    return v + (excess * part) * along;
  }
  constexpr components slip_of_friction(const components& slip, const touching& at,
                                        const mechanism& m) const {
    return stretched(in_tangent_plane(slip, at), at, m);
  }

  /// The friction force of the bristles and their rates. In a plane of contact that turns, the deflection is
  /// a vector of which only the part in this plane pulls: the slip has no other part, so that the power is
  /// that of the whole deflection.
  template <class Motion>
  constexpr moving_bristles move_bristles(Motion& on, expression pressing, const components& slip) const {
    sequence<expression> parts;
    for (const components& t : between.directions_of_slip()) parts.push(dot(t, slip));
    return friction.known_in(on).move_bristles(pressing, parts);
  }
  constexpr components force_of(const moving_bristles& moving, const touching& at) const {
    const sequence<components> along = between.directions_of_slip();
    components force(at.normal.x.owner());
    for (int i = 0; i < along.size(); ++i) force += moving.force[i] * along[i];
    return between.has_plane() ? force : in_tangent_plane(force, at);
  }

  template <class Motion>
  constexpr components tangential_force(Motion& on, const touching& at, const components& slip,
                                        expression pressing) const {
    const mechanism& m = *on.skeleton_used().model;
    if (!friction) return components(*m.g);
    const components tangent = slip_of_friction(slip, at, m);
    if (friction.has_bristles()) return stretched(force_of(move_bristles(on, pressing, tangent), at), at, m);
    const components force = -((pressing * friction.known_in(on).over_slip(dot(tangent, tangent))) * tangent);
    return stretched(force, at, m);
  }

public:
  constexpr void act(force_system& on, conservative how) const {
    const touching at = between.at(*on.skeleton_used().model);
    const components slip = relative_velocity(on.moving(), at);
    const expression elastic = law.elastic_force(at.penetration), pressing = pressed_by(elastic, at, slip);
    const expression as_force = how == conservative::by_energy ? pressing - elastic : pressing;
    add_force(on, at, as_force * at.push, tangential_force(on, at, slip, pressing));
    if (friction.has_bristles())
      add_shares(on, move_bristles(on, pressing, slip_of_friction(slip, at, *on.skeleton_used().model)));
    if (!rolling && !spinning) return;
    const components w = relative_spin(on.skeleton_used()), about_normal = dot(w, at.normal) * at.normal;
    if (rolling) add_resistance(on, rolling, pressing, w - about_normal);
    if (spinning) add_resistance(on, spinning, pressing, about_normal);
  }

  /// The normal force, which is not negative.
  constexpr expression normal_force(observed_motion& on) const {
    const touching at = between.at(*on.skeleton_used().model);
    return pressed_by(law.elastic_force(at.penetration), at, relative_velocity(on.moving(), at));
  }

  /// The friction force on the first body.
  constexpr vector friction_force(observed_motion& on) const {
    const touching at = between.at(*on.skeleton_used().model);
    const components slip = relative_velocity(on.moving(), at);
    const expression pressing = pressed_by(law.elastic_force(at.penetration), at, slip);
    return in_axes(tangential_force(on, at, slip, pressing));
  }

  /// The sum of the normal force and the friction, on the first body.
  constexpr vector force(observed_motion& on) const {
    const touching at = between.at(*on.skeleton_used().model);
    const components slip = relative_velocity(on.moving(), at);
    const expression pressing = pressed_by(law.elastic_force(at.penetration), at, slip);
    return in_axes(pressing * at.push + tangential_force(on, at, slip, pressing));
  }

  /// The position of the contact from the point of the first body.
  constexpr vector place(observed_motion& on) const {
    return in_axes(between.at(*on.skeleton_used().model).arm);
  }

  /// Appends the rates of the deflections of bristles.
  constexpr void add_state_rates(force_system& on, sequence<state_rate>& all) const {
    if (!friction.has_bristles()) return;
    const mechanism& m = *on.skeleton_used().model;
    const touching at = between.at(m);
    const components slip = relative_velocity(on.moving(), at);
    const expression pressing = pressed_by(law.elastic_force(at.penetration), at, slip);
    const moving_bristles moving = move_bristles(on, pressing, slip_of_friction(slip, at, m));
    for (int i = 0; i < moving.rates.size(); ++i)
      all.push({m.speeds.find(friction.bristles.deflections[i]), moving.rates[i], {}});
  }

  constexpr expression potential_energy(const mechanism& m) const {
    return law.energy(between.at(m).penetration);
  }

  constexpr void check_with(load_check& by, int) const;
  constexpr void state_units(load_units& by, int) const;

private:
  constexpr void check_surface(load_check& by, std::string_view names) const;

  /// Whether the point of the first body is at rest in the frame of the second, so that the penetration never
  /// changes; a body that turns about this point may nevertheless roll or slip.
  constexpr bool is_constant(const mechanism& m) const {
    const int base = rigid_base(m, between.other);
    if (frame_of_constant_position(m, between.point, between.against) != base) return false;
    return between.frame == none || rigid_base(m, between.frame) == base;
  }

  constexpr void add_shares(force_system& on, const moving_bristles& moving) const {
    const mechanism& m = *on.skeleton_used().model;
    for (int i = 0; i < moving.rates.size(); ++i)
      on.add_share(m.speeds.find(friction.bristles.deflections[i]), moving.rates[i]);
  }

  constexpr vector in_axes(const components& v) const {
    vector all;
    all.add(between.other, v);
    return all;
  }

  /// The angular velocity of the first body relative to the second.
  constexpr components relative_spin(const skeleton& s) const {
    return express(*s.model, angular_velocity_between(s, between.frame, between.other), between.other);
  }

  /// The velocity of the material point of the first body at the contact, relative to that of the second.
  constexpr components relative_velocity(motion& k, const touching& at) const {
    const skeleton& s = k.skeleton_used();
    const mechanism& m = *s.model;
    const int first = s.station_of_point[between.point], second = s.station_of_point[between.against];
    components v = express(m, velocity_between(k, first, second), between.other);
    if (s.rigid_with[between.other] != mechanism::inertial) {
      vector w;
      w.add(s.working_axes[s.rigid_with[between.other]], k.angular_velocity(between.other));
      v -= cross(express(m, w, between.other), at.line);
    }
    if (between.frame != none) v += cross(relative_spin(s), at.arm);
    return v;
  }

  constexpr void add_force(force_system& on, const touching& at, const components& pressing,
                           const components& tangential) const {
    const skeleton& s = on.skeleton_used();
    const components force = pressing + tangential;
    on.add_force(between.point, in_axes(force));
    on.add_force(between.against, in_axes(-force));
    if (between.frame != none) {
      const components moment = cross(at.arm, between.is_round() ? tangential : force);
      if (!moment.is_zero()) on.add_torque(between.frame, none, in_axes(moment));
    }
    if (s.rigid_with[between.other] == mechanism::inertial) return;
    const components moment = cross(at.line + at.arm, force);
    on.add_torque(between.other, none, in_axes(-moment));
  }

  constexpr void add_resistance(force_system& on, const rotation_resistance& by, expression normal_force,
                                const components& w) const {
    const expression rest = by.angular_velocity * by.angular_velocity;
    const expression size = sqrt(dot(w, w) + rest);
    const expression factor = by.lever * normal_force / size;
    on.add_torque(between.frame, between.other, in_axes(-(factor * w)));
  }
};

constexpr void contact::check_with(load_check& by, int) const {
  const mechanism& m = by.mechanism_used();
  const sentence names = by.ends_of(between);
  if (between.point == between.against || between.frame == between.other)
    return by.fail({"a contact between ", names.view(), " is between a body and itself"});
  const int origin = origin_of(m, between.point), other = origin_of(m, between.against);
  if (origin != other)
    return by.fail({"the contact between ", names.view(), " has points measured from two origins, ",
                    by.point(origin), " and ", by.point(other), ", whose distance is not known"});
  if (between.has_plane() && !is_fixed(between.normal))
    return by.fail({"the normal of the contact between ", names.view(), " is not fixed in ",
                    by.frame(between.other), "; its components may contain only numbers and parameters"});
  if (between.is_singular(m))
    return by.fail(
        {"the axis of the torus of the contact between ", names.view(), " is parallel to the normal"});
  if (is_constant(m))
    return by.fail(
        {"the bodies of the contact between ", names.view(), " never move relative to each other"});
  if ((rolling || spinning) && between.frame == none)
    return by.fail({"the contact between ", names.view(),
                    " has a resistance to rolling or spinning, but a point does not turn"});
  if (between.shapes == contact_shapes::torus_on_plane && !is_fixed(between.axis))
    return by.fail({"the axis of the torus of the contact between ", names.view(), " is not fixed in ",
                    by.frame(between.axis_frame),
                    "; its components may contain only numbers and parameters"});
  if (between.shapes == contact_shapes::torus_on_plane &&
      !is_at_rest_in(m, between.axis, between.axis_frame, between.frame))
    return by.fail({"the axis of the torus of the contact between ", names.view(), " turns in ",
                    by.frame(between.frame), ", the frame of its body"});
  const auto constant = [&](expression e, std::string_view what, bool is_positive) {
    if (!e.is_given()) return;
    by.check_constant(e, what, names.view());
    if (is_positive) by.check_positive(e, what, names.view());
  };
  const auto fixed = [&](expression e, std::string_view what) {
    if (!e.is_given()) return;
    by.check_fixed(e, what, names.view());
    by.check_not_negative(e, what, names.view());
  };
  constant(law.stiffness, "the stiffness of the contact between ", true);
  constant(law.width, "the width of the contact between ", true);
  constant(law.damping, "the damping of the contact between ", false);
  fixed(between.radius, "the radius of the contact between ");
  fixed(between.other_radius, "the second radius of the contact between ");
  constant(rolling.lever, "the lever of the rolling resistance between ", false);
  constant(rolling.angular_velocity, "the angular velocity of the rolling resistance between ", true);
  constant(spinning.lever, "the lever of the spinning resistance between ", false);
  constant(spinning.angular_velocity, "the angular velocity of the spinning resistance between ", true);
  const sentence whose({"the contact between ", names.view()});
  friction.check_with(by, whose.view());
  if (direction) {
    constant(direction.ratio, "the ratio of the directional friction of the contact between ", true);
    if (!is_fixed(direction.unit))
      return by.fail({"the direction of the friction of the contact between ", names.view(),
                      " is not fixed in ", by.frame(direction.frame),
                      "; its components may contain only numbers and parameters"});
    if (!friction) return by.fail({whose.view(), " has a direction of friction, but no law of friction"});
    if (between.has_plane() && direction.frame == between.other &&
        cross(direction.unit, between.normal).is_zero())
      return by.fail({"the direction of the friction of the contact between ", names.view(),
                      " is parallel to the normal"});
  }
  if (law.damping.is_given())
    by.check_not_negative(law.damping, "the damping of the contact between ", names.view());
  if (rolling)
    by.check_not_negative(rolling.lever, "the lever of the rolling resistance between ", names.view());
  if (spinning)
    by.check_not_negative(spinning.lever, "the lever of the spinning resistance between ", names.view());
  if (between.level.is_given()) check_surface(by, names.view());
  if (!friction.has_bristles() || by.mistake()) return;
  const int directions = between.directions_of_slip().size(), given = friction.bristles.deflections.size();
  if (directions == 0)
    return by.fail({whose.view(), " has bristles, whose directions do not follow from its normal; turn ",
                    by.frame(between.other), " so that a component of the normal is zero"});
  if (directions != given)
    by.fail({whose.view(), " has ", several(given, "bristle").view(), ", expected ",
             base::counted(directions).view()});
}

/// Reports a surface that does not depend on the coordinates of the point, or that changes, which would
/// contribute a further velocity.
constexpr void contact::check_surface(load_check& by, std::string_view names) const {
  by.check_fixed(between.level, "the surface of the contact between ", names);
  const components place = surface_coordinates(between.level.owner());
  bool depends = false;
  for (int i = 0; i < 3; ++i)
    depends = depends || !symbolic::differentiate(between.level, place[i]).is_zero();
  if (!depends)
    by.fail({"the surface of the contact between ", names,
             " does not depend on surface::x, surface::y or surface::z"});
}

constexpr void contact::state_units(load_units& by, int) const {
  namespace si = units::si;
  const sentence names = by.ends_of(between);
  const auto state = [&](expression e, std::string_view what, const units::unit& u) {
    if (!e.is_given()) return;
    by.describe({what, names.view()});
    by.expect(e, u);
  };
  state(between.radius, "the radius of the contact between ", si::meter);
  state(between.other_radius, "the second radius of the contact between ", si::meter);
  state(law.width, "the width of the contact between ", si::meter);
  if (between.level.is_given()) {
    const components place = surface_coordinates(between.level.owner());
    for (int i = 0; i < 3; ++i) state(place[i], "a coordinate of the surface between ", si::meter);
  }
  const expression n = law.exponent;
  state(law.stiffness * power(law.width, n), "the stiffness of the contact between ", si::newton);
  state(law.damping, "the damping of the contact between ", si::second / si::meter);
  state(friction.slip_speed, "the slip speed of the contact between ", si::meter / si::second);
  state(friction.sliding, "the coefficient of friction of the contact between ", units::dimensionless);
  state(friction.sticking, "the coefficient of static friction of the contact between ",
        units::dimensionless);
  state(friction.viscous, "the viscous coefficient of the contact between ", si::second / si::meter);
  state(friction.bristles.stiffness, "the stiffness of the bristles of the contact between ",
        units::dimensionless / si::meter);
  state(friction.bristles.damping, "the damping of the bristles of the contact between ",
        si::second / si::meter);
  state(friction.bristles.stribeck_speed, "the Stribeck speed of the contact between ",
        si::meter / si::second);
  for (const expression& z : friction.bristles.deflections)
    state(z, "the deflection of a bristle of the contact between ", si::meter * units::pow<1, 2>(si::newton));
  state(direction.ratio, "the ratio of the directional friction of the contact between ",
        units::dimensionless);
  state(rolling.lever, "the lever of the rolling resistance between ", si::meter);
  state(rolling.angular_velocity, "the angular velocity of the rolling resistance between ",
        si::radian / si::second);
  state(spinning.lever, "the lever of the spinning resistance between ", si::meter);
  state(spinning.angular_velocity, "the angular velocity of the spinning resistance between ",
        si::radian / si::second);
}

} // namespace kanexpr::mechanics
