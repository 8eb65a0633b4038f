#pragma once

#include <kanexpr/derivation/read/direction_reader.hpp>
#include <kanexpr/derivation/read/friction_reader.hpp>
#include <kanexpr/derivation/read/load_parts.hpp>
#include <kanexpr/derivation/read/value.hpp>
#include <kanexpr/describe/contact_record.hpp>
#include <kanexpr/describe/load_quantities.hpp>
#include <kanexpr/mechanics/loads/add_bristles.hpp>
#include <kanexpr/mechanics/loads/contact.hpp>
#include <kanexpr/mechanics/loads/contact_geometry.hpp>
#include <kanexpr/mechanics/loads/contact_law.hpp>
#include <kanexpr/mechanics/loads/observed_motion.hpp>
#include <kanexpr/mechanics/loads/restitution.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/numbers/number.hpp>

#include <string_view>

namespace kanexpr::derivation {

/// Reads contacts.
class contact_reader : load_parts {
public:
  constexpr explicit contact_reader(const load_parts& by) : load_parts(by) {}

  constexpr mechanics::contact read(const describe::contact_record& r) {
    mechanics::contact c;
    lay_out(c.between, r);
    c.law.stiffness = scalar(r.stiffness, "the stiffness of ");
    c.law.exponent = exponent_of(r.exponent);
    c.law.width = scalar(r.width, "the width of ");
    expression slip{};
    if (r.approach_speed.tokens != nullptr) {
      const expression approach = scalar(r.approach_speed, "the approach speed of ");
      if (reading_.mistake) return c;
      if (approach.is_constant() && !(approach.owner().number_at(approach.node()).value() > 0))
        reading_.fail({"the approach speed of ", whom, " is not positive"});
      if (reading_.mistake) return c;
      const double damping = mechanics::damping_of_restitution(r.restitution);
      if (r.restitution < 1) c.law.damping = approach.number(symbolic::real(damping)) / approach;
      slip = approach / 100;
    }
    if (r.damping.tokens != nullptr) c.law.damping = scalar(r.damping, "the damping of ");
    if (r.friction != nullptr && !reading_.mistake) c.friction = read_friction_law(*this, *r.friction, slip);
    if (r.lever.tokens != nullptr) {
      c.rolling.lever = scalar(r.lever, "the lever of the rolling resistance of ");
      c.rolling.angular_velocity =
          scalar(r.rolling_rate, "the angular velocity of the rolling resistance of ");
    }
    if (r.spinning_lever.tokens != nullptr) {
      c.spinning.lever = scalar(r.spinning_lever, "the lever of the spinning resistance of ");
      c.spinning.angular_velocity =
          scalar(r.spinning_rate, "the angular velocity of the spinning resistance of ");
    }
    if (r.direction.tokens != nullptr) {
      c.direction.unit =
          read_direction(*this, r.direction, "the direction of the friction of ", c.direction.frame);
      c.direction.ratio = scalar(r.ratio, "the ratio of the directional friction of ");
    }
    if (!reading_.mistake && c.rolling && c.between.frame == none)
      reading_.fail({whom, " has rolling_resistance<...>, but a point does not roll"});
    if (!reading_.mistake && c.spinning && c.between.frame == none)
      reading_.fail({whom, " has spinning_resistance<...>, but a point does not turn"});
    return c;
  }

private:
  constexpr void lay_out(mechanics::contact_geometry& g, const describe::contact_record& r) {
    g.shapes = r.shapes;
    g.point = entities_.point(r.point, whom);
    g.against = entities_.point(r.other_point, whom);
    if (r.frame != nullptr) g.frame = entities_.frame(r.frame, whom);
    if (r.other_frame != nullptr) g.other = entities_.frame(r.other_frame, whom);
    if (r.normal.tokens != nullptr) g.normal = read_direction(*this, r.normal, "the normal of ", g.other);
    int frame_of_axis = g.frame;
    if (r.axis.tokens != nullptr) g.axis = read_direction(*this, r.axis, "the axis of ", frame_of_axis);
    g.axis_frame = frame_of_axis;
    if (r.level.tokens != nullptr) {
      reading_.is_on_surface = true;
      g.level = scalar(r.level, "the surface of ");
      reading_.is_on_surface = false;
    }
    g.radius = scalar(r.radius, "the radius of ");
    if (r.other_radius.tokens != nullptr) g.other_radius = scalar(r.other_radius, "the second radius of ");
  }

  constexpr expression exponent_of(const phrase& p) {
    const expression n = scalar(p, "the exponent of ");
    if (reading_.mistake) return n;
    const expression exact = mechanics::contact_exponent(n);
    if (!exact.is_given()) reading_.fail({"the exponent of ", whom, " is not a number from 1 to 30"});
    return exact;
  }
};

constexpr void read_contact(load_parts& by) {
  const describe::contact_record& r = *by.record.contact;
  if (!r.mistake.empty()) return by.fail({by.whom, " ", r.mistake});
  const mechanics::contact c = contact_reader(by).read(r);
  if (by.has_mistake()) return;
  by.into.add(c);
  mechanics::add_bristles(by.model(), by.into, c.friction);
}

/// A quantity of the only load, a contact.
constexpr value observe_contact(describe::load_quantity wanted, const mechanics::loads& alone,
                                mechanics::observed_motion& on) {
  const mechanics::contact c = alone.all<mechanics::contact>()[0];
  switch (wanted) {
  case describe::load_quantity::normal_force: return value::of(c.normal_force(on));
  case describe::load_quantity::friction_force: return value::of(c.friction_force(on));
  case describe::load_quantity::contact_force: return value::of(c.force(on));
  case describe::load_quantity::contact_place: return value::of(c.place(on));
  case describe::load_quantity::length:
  case describe::load_quantity::penetration:
  case describe::load_quantity::tension:
  case describe::load_quantity::longitudinal_force:
  case describe::load_quantity::lateral_force:
  case describe::load_quantity::aligning_moment:
  case describe::load_quantity::longitudinal_slip:
  case describe::load_quantity::lateral_slip:
  case describe::load_quantity::camber:
  case describe::load_quantity::lowest_point: break;
  }
  return {};
}

} // namespace kanexpr::derivation
