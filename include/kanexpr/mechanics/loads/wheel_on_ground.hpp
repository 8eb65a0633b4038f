#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/mechanics/loads/contact_geometry.hpp>
#include <kanexpr/mechanics/loads/force_system.hpp>
#include <kanexpr/mechanics/loads/load_check.hpp>
#include <kanexpr/mechanics/loads/load_units.hpp>
#include <kanexpr/mechanics/loads/wheel_contact.hpp>
#include <kanexpr/mechanics/loads/wheel_shapes.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/fixed.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/orientation.hpp>
#include <kanexpr/mechanics/model/position.hpp>
#include <kanexpr/mechanics/motion/direction_at_rest.hpp>
#include <kanexpr/mechanics/motion/motion.hpp>
#include <kanexpr/mechanics/motion/relative_motion.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/units/si.hpp>

#include <string_view>

namespace kanexpr::mechanics {

/// The velocities of a wheel at its contact, relative to the ground. The material point is the one of the
/// wheel, which is on the rim at one instant only; a force at it that is opposite to its velocity takes
/// energy.
struct wheel_motion {
  expression approach{};      ///< δ̇, the velocity of the material point into the ground
  expression forward_slip{};  ///< the velocity of the material point along `forward`
  expression lateral_slip{};  ///< the velocity of the material point along `lateral`
  expression spin{};          ///< Ω, the angular velocity about the axis relative to the plane of lean
  expression turn{};          ///< the angular velocity about the normal, relative to the ground
  expression forward_speed{}; ///< of the contact point along the ground: `forward_slip` + `loaded_radius` Ω
};

/// A wheel, which is a body of revolution about an axis through its center, and the ground below it.
struct wheel_on_ground {
  rim_shape rim{};
  ground_shape ground{};
  int point = none;      ///< the center of the wheel
  int against = none;    ///< a point of the ground
  int frame = none;      ///< the frame of the wheel
  int other = none;      ///< the frame of the ground
  components axis{};     ///< the unit axis of the wheel, to its left, in the axes of `axis_frame`
  int axis_frame = none; ///< a frame in which the axis is fixed
  expression radius{};   ///< of the circle of the centers of the tube, or of a cone at its center
  expression tube{};     ///< the radius of the tube
  expression conicity{}; ///< of a cone: the slope of its radius along the axis
  components normal{};   ///< of a plane, or the direction up of a rail, in the axes of `other`
  components along{};    ///< the direction of a rail, in the axes of `other`
  expression head{};     ///< the radius of the head of a rail
  expression height{};   ///< f of an uneven ground z = f(x, y), in terms of `surface_coordinates`
  int steps = 0;         ///< of Newton's method toward the lowest point above an uneven ground

  template <class Self, class Visit>
  static constexpr void each_member(Self& self, Visit&& visit) {
    visit(self.rim, self.ground, self.point, self.against, self.frame, self.other, self.axis, self.axis_frame,
          self.radius, self.tube, self.conicity, self.normal, self.along, self.head, self.height, self.steps);
  }

  constexpr wheel_contact contact(const mechanism& m) const {
    const components line = express(m, position_from(m, against, point), other);
    vector left;
    left.add(axis_frame, axis);
    const components a = express(m, left, other);
    switch (ground) {
    case ground_shape::flat: return touch_plane(line, a, normal, radius, tube);
    case ground_shape::uneven: return touch_surface(line, a, radius, tube, height, steps);
    case ground_shape::rail: return touch_rail(line, a, radius, conicity, {along, normal, head});
    }
    __builtin_unreachable();
  }

  constexpr wheel_motion motion_at(motion& k, const wheel_contact& at) const {
    const skeleton& s = k.skeleton_used();
    const mechanism& m = *s.model;
    const components w = express(m, angular_velocity_between(s, frame, other), other);
    const components v = velocity_of_center(k, at) + cross(w, at.arm);
    wheel_motion moves;
    moves.approach = -dot(at.normal, v);
    moves.forward_slip = dot(at.forward, v), moves.lateral_slip = dot(at.lateral, v);
    moves.turn = dot(w, at.normal);
    // w = Ω a + ψ̇ n + γ̇ forward
    const expression about_axis = dot(w, at.axis), lean = at.camber_sine;
    moves.spin = (about_axis - lean * moves.turn) / (1 - lean * lean);
    moves.forward_speed = moves.forward_slip + at.loaded_radius * moves.spin;
    return moves;
  }

  /// Adds a force on the wheel at its contact point, and the opposite force on the ground.
  constexpr void add_force(force_system& on, const wheel_contact& at, const components& force) const {
    on.add_force(point, in_axes(force));
    on.add_force(against, in_axes(-force));
    on.add_torque(frame, none, in_axes(cross(at.arm, force)));
    if (on.skeleton_used().rigid_with[other] != mechanism::inertial)
      on.add_torque(other, none, in_axes(-cross(at.line + at.arm, force)));
  }

  /// Adds a torque on the wheel, and the opposite torque on the ground.
  constexpr void add_torque(force_system& on, const components& torque) const {
    on.add_torque(frame, other, in_axes(torque));
  }

  /// Checks the geometry of a load `what`, such as "the tyre".
  constexpr void check_with(load_check& by, std::string_view what) const;
  constexpr void state_units(load_units& by, std::string_view what) const;

private:
  constexpr vector in_axes(const components& v) const {
    vector all;
    all.add(other, v);
    return all;
  }

  /// The velocity of the center relative to the material point of the ground at the same place.
  constexpr components velocity_of_center(motion& k, const wheel_contact& at) const {
    const skeleton& s = k.skeleton_used();
    const mechanism& m = *s.model;
    const vector between = velocity_between(k, s.station_of_point[point], s.station_of_point[against]);
    components v = express(m, between, other);
    if (s.rigid_with[other] == mechanism::inertial) return v;
    vector w;
    w.add(s.working_axes[s.rigid_with[other]], k.angular_velocity(other));
    v -= cross(express(m, w, other), at.line);
    return v;
  }
};

constexpr void wheel_on_ground::check_with(load_check& by, std::string_view what) const {
  const mechanism& m = by.mechanism_used();
  const sentence names({what, " between ", by.ends_of(*this).view()});
  if (point == against || frame == other) return by.fail({names.view(), " is between a body and itself"});
  const int origin = origin_of(m, point), other_origin = origin_of(m, against);
  if (origin != other_origin)
    return by.fail({names.view(), " has points measured from two origins, ", by.point(origin), " and ",
                    by.point(other_origin), ", whose distance is not known"});
  const auto fixed = [&](const components& direction, std::string_view part, int in) {
    if (!direction.x.is_given() || is_fixed(direction)) return;
    by.fail({part, names.view(), " is not fixed in ", by.frame(in),
             "; its components may contain only numbers and parameters"});
  };
  fixed(axis, "the axis of ", axis_frame);
  fixed(normal, "the normal of ", other);
  fixed(along, "the direction of the rail of ", other);
  if (is_fixed(axis) && !is_at_rest_in(m, axis, axis_frame, frame))
    by.fail({"the axis of ", names.view(), " turns in ", by.frame(frame), ", the frame of its body"});
  const auto constant = [&](expression e, std::string_view part) {
    if (e.is_given()) by.check_constant(e, part, names.view());
  };
  constant(radius, "the radius of ");
  constant(tube, "the radius of the tube of ");
  constant(conicity, "the conicity of ");
  constant(head, "the radius of the head of the rail of ");
  constant(height, "the height of the ground of ");
  by.check_positive(radius, "the radius of ", names.view());
  if (tube.is_given()) by.check_not_negative(tube, "the radius of the tube of ", names.view());
  if (head.is_given()) by.check_not_negative(head, "the radius of the head of the rail of ", names.view());
  if (!height.is_given()) return;
  const expression z = surface_coordinates(height.owner()).z;
  if (!symbolic::differentiate(height, z).is_zero())
    by.fail({"the height of the ground of ", names.view(),
             " contains surface::z; it is a function of "
             "surface::x and surface::y"});
}

constexpr void wheel_on_ground::state_units(load_units& by, std::string_view what) const {
  namespace si = units::si;
  const sentence names({what, " between ", by.ends_of(*this).view()});
  const auto state = [&](expression e, std::string_view part, const units::unit& u) {
    if (!e.is_given()) return;
    by.describe({part, names.view()});
    by.expect(e, u);
  };
  state(radius, "the radius of ", si::meter);
  state(tube, "the radius of the tube of ", si::meter);
  state(conicity, "the conicity of ", units::dimensionless);
  state(head, "the radius of the head of the rail of ", si::meter);
  if (!height.is_given()) return;
  const components place = surface_coordinates(height.owner());
  for (int i = 0; i < 2; ++i) state(place[i], "a coordinate of the ground of ", si::meter);
  state(height, "the height of the ground of ", si::meter);
}

} // namespace kanexpr::mechanics
