#pragma once

#include <kanexpr/mechanics/loads/add_bristles.hpp>
#include <kanexpr/mechanics/loads/contact.hpp>
#include <kanexpr/mechanics/loads/contact_geometry.hpp>
#include <kanexpr/mechanics/loads/contact_law.hpp>
#include <kanexpr/mechanics/loads/contact_shapes.hpp>
#include <kanexpr/mechanics/loads/friction_kind.hpp>
#include <kanexpr/mechanics/loads/loads.hpp>
#include <kanexpr/mechanics/loads/observed_motion.hpp>
#include <kanexpr/mechanics/loads/restitution.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/runtime/building/contact_builder.hpp>
#include <kanexpr/runtime/building/contact_data.hpp>
#include <kanexpr/runtime/building/number_or_expression.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/numbers/number.hpp>

#include <string_view>

namespace kanexpr::runtime {

KANEXPR_ENGINE void contact_builder::sphere_on_plane(point_id center, frame_id of,
                                                     const number_or_expression& radius, point_id in_plane,
                                                     const vector& normal, const contact_data& data) {
  mechanics::contact_geometry g;
  g.shapes = mechanics::contact_shapes::sphere_on_plane;
  g.point = place(center), g.frame = place(of), g.against = place(in_plane);
  g.radius = as_nonzero(radius, "a radius of a contact");
  if (checks_.owns("a contact", center, of, in_plane) &&
      set_direction(g.normal, g.other, normal, "a contact"))
    add_contact(g, data);
}

KANEXPR_ENGINE void contact_builder::point_on_plane(point_id point, point_id in_plane, const vector& normal,
                                                    const contact_data& data) {
  mechanics::contact_geometry g;
  g.shapes = mechanics::contact_shapes::sphere_on_plane;
  g.point = place(point), g.against = place(in_plane);
  g.radius = m_.zero();
  if (checks_.owns("a contact", point, in_plane) && set_direction(g.normal, g.other, normal, "a contact"))
    add_contact(g, data);
}

KANEXPR_ENGINE void contact_builder::torus_on_plane(point_id center, frame_id of, const vector& axis,
                                                    const number_or_expression& circle,
                                                    const number_or_expression& tube, point_id in_plane,
                                                    const vector& normal, const contact_data& data) {
  mechanics::contact_geometry g;
  g.shapes = mechanics::contact_shapes::torus_on_plane;
  g.point = place(center), g.frame = place(of), g.against = place(in_plane);
  g.radius = as_nonzero(tube, "a radius of a contact");
  g.other_radius = as_nonzero(circle, "a radius of a contact");
  if (checks_.owns("a contact", center, of, in_plane) &&
      set_direction(g.axis, g.axis_frame, axis, "a contact") &&
      set_direction(g.normal, g.other, normal, "a contact"))
    add_contact(g, data);
}

KANEXPR_ENGINE void contact_builder::sphere_on_sphere(point_id center, frame_id of,
                                                      const number_or_expression& radius,
                                                      point_id other_center, frame_id other,
                                                      const number_or_expression& other_radius,
                                                      const contact_data& data) {
  mechanics::contact_geometry g;
  g.shapes = mechanics::contact_shapes::sphere_on_sphere;
  g.point = place(center), g.frame = place(of);
  g.against = place(other_center), g.other = place(other);
  g.radius = as_nonzero(radius, "a radius of a contact");
  g.other_radius = as_nonzero(other_radius, "a radius of a contact");
  if (checks_.owns("a contact", center, of, other_center, other)) add_contact(g, data);
}

KANEXPR_ENGINE void contact_builder::add_surface_contact(point_id point, point_id origin, frame_id of,
                                                         expression level, const contact_data& data) {
  mechanics::contact_geometry g;
  g.shapes = mechanics::contact_shapes::point_on_surface;
  g.point = place(point), g.against = place(origin), g.other = place(of);
  g.level = level, g.radius = m_.zero();
  if (checks_.owns("a contact", point, origin, of, level)) add_contact(g, data);
}

KANEXPR_ENGINE void contact_builder::add_contact(const mechanics::contact_geometry& between,
                                                 const contact_data& data) {
  mechanics::contact c{between, {}, data.friction, data.rolling, data.spinning, {}};
  if (data.rolling.lever.is_given() != data.rolling.angular_velocity.is_given()) {
    checks_.fail({"the rolling resistance of a contact needs a lever and an angular velocity"});
    return;
  }
  if (data.spinning.lever.is_given() != data.spinning.angular_velocity.is_given()) {
    checks_.fail({"the spinning resistance of a contact needs a lever and an angular velocity"});
    return;
  }
  c.law.stiffness = as_nonzero(data.stiffness, "the stiffness of a contact");
  c.law.width = as_nonzero(data.width, "the width of a contact");
  c.law.exponent = mechanics::contact_exponent(constant(data.exponent));
  if (!c.law.exponent.is_given()) {
    checks_.fail({"the exponent of a contact is not a number from 1 to 30"});
    return;
  }
  if (data.damping) c.law.damping = as_nonzero(*data.damping, "the damping of a contact");
  if (data.restitution) {
    const double e = data.restitution->coefficient;
    if (!(e > 0 && e <= 1)) checks_.fail({"a coefficient of restitution is not in (0, 1]"});
    if (data.damping) checks_.fail({"a contact has both a restitution and a damping"});
    const expression approach =
        as_nonzero(data.restitution->approach_speed, "the approach speed of a contact");
    if (!checks_.owns("a contact", approach)) return;
    if (approach.is_constant() && !(m_.g->number_at(approach.node()).value() > 0)) {
      checks_.fail({"the approach speed of a contact is not positive"});
      return;
    }
    if (e < 1)
      c.law.damping = approach.number(symbolic::real(mechanics::damping_of_restitution(e))) / approach;
    c.friction.take_slip_speed(approach / 100);
  }
  if (data.directional) {
    if (!set_direction(c.direction.unit, c.direction.frame, data.directional->direction, "a contact")) return;
    c.direction.ratio = as_nonzero(data.directional->ratio, "the ratio of the friction of a contact");
    if (!checks_.owns("a contact", c.direction.ratio)) return;
  }
  const auto is_owned = [&](expression e) { return !e.is_given() || checks_.owns("a contact", e); };
  for (const expression e :
       {c.friction.sliding, c.friction.sticking, c.friction.slip_speed, c.friction.viscous,
        c.friction.bristles.stiffness, c.friction.bristles.damping, c.friction.bristles.stribeck_speed,
        c.rolling.lever, c.rolling.angular_velocity, c.spinning.lever, c.spinning.angular_velocity,
        c.law.damping, between.other_radius})
    if (!is_owned(e)) return;
  if (!checks_.owns("a contact", c.friction.bristles.deflections)) return;
  if (c.rolling && between.frame == mechanics::none) {
    checks_.fail({"a contact has a rolling resistance, but a point does not roll"});
  } else if (c.friction.needs_coefficient()) {
    checks_.fail({"the friction of a contact has no coefficient"});
  } else if (c.friction.needs_slip_speed()) {
    checks_.fail({"the friction of a contact has no slip speed"});
  } else if (checks_.owns("a contact", c.law.stiffness, c.law.width, between.radius)) {
    system_.loads.add(c);
    mechanics::add_bristles(m_, system_.loads, c.friction);
  }
}

KANEXPR_ENGINE bool contact_builder::has_contact(int numbered, const mechanics::known_motion& known) {
  const int contacts = system_.loads.all<mechanics::contact>().size();
  if (numbered < 1 || numbered > contacts)
    return checks_.fail({"the force of contact ", base::counted(numbered).view(),
                         " is requested, but the number of contacts is ", base::counted(contacts).view()});
  return is_own(known, "the force of a contact");
}

KANEXPR_ENGINE expression contact_builder::normal_force_of(int contact, mechanics::known_motion& known) {
  if (!has_contact(contact, known)) return m_.zero();
  mechanics::observed_motion on(known.moving());
  return system_.loads.all<mechanics::contact>()[contact - 1].normal_force(on);
}

KANEXPR_ENGINE vector contact_builder::friction_force_of(int contact, mechanics::known_motion& known) {
  if (!has_contact(contact, known)) return {};
  mechanics::observed_motion on(known.moving());
  return system_.loads.all<mechanics::contact>()[contact - 1].friction_force(on);
}

} // namespace kanexpr::runtime
