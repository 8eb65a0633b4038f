#pragma once

#include <kanexpr/base/name.hpp>
#include <kanexpr/mechanics/loads/load_check.hpp>
#include <kanexpr/mechanics/loads/wheel_contact.hpp>
#include <kanexpr/mechanics/loads/wheel_on_ground.hpp>
#include <kanexpr/mechanics/loads/wheel_shapes.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/runtime/building/wheel_builder.hpp>
#include <kanexpr/runtime/building/wheel_data.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>

namespace kanexpr::runtime {

KANEXPR_ENGINE wheel_on_ground wheel_builder::wheel_on(const wheel_data& wheel, point_id ground) {
  wheel_on_ground w;
  w.point = place(wheel.center), w.frame = place(wheel.frame), w.against = place(ground);
  w.radius = as_nonzero(wheel.radius, "the radius of a wheel");
  w.tube = as_nonzero(wheel.tube, "the radius of the tube of a wheel");
  if (checks_.owns("a wheel", wheel.center, wheel.frame, ground, w.radius, w.tube))
    set_direction(w.axis, w.axis_frame, wheel.axis, "a wheel");
  return w;
}

KANEXPR_ENGINE wheel_on_ground wheel_builder::wheel_on_plane(const wheel_data& wheel, point_id in_plane,
                                                             const vector& normal) {
  wheel_on_ground w = wheel_on(wheel, in_plane);
  set_direction(w.normal, w.other, normal, "a wheel");
  return w;
}

KANEXPR_ENGINE wheel_on_ground wheel_builder::wheel_on_height(const wheel_data& wheel, point_id origin,
                                                              frame_id of, expression height, int steps) {
  if (steps < 0 || steps > 9)
    checks_.fail({"expected 0 to 9 steps to the lowest point of a wheel, got ", base::counted(steps).view()});
  wheel_on_ground w = wheel_on(wheel, origin);
  w.ground = mechanics::ground_shape::uneven;
  w.other = place(of), w.height = height, w.steps = steps;
  checks_.owns("a wheel", of, height);
  return w;
}

KANEXPR_ENGINE wheel_on_ground wheel_builder::wheel_on_rail(const wheel_data& wheel, const rail_data& rail) {
  wheel_on_ground w = wheel_on(wheel, rail.on_top);
  w.rim = mechanics::rim_shape::conical, w.ground = mechanics::ground_shape::rail;
  w.conicity = as_nonzero(wheel.conicity, "the conicity of a wheel");
  w.head = as_nonzero(rail.radius, "the radius of the head of a rail");
  checks_.owns("a wheel", w.conicity, w.head);
  int frame = mechanics::none;
  if (set_direction(w.normal, w.other, rail.up, "a rail") &&
      set_direction(w.along, frame, rail.along, "a rail") && frame != w.other)
    checks_.fail({"a rail has directions in the axes of two frames; give both in the axes of one"});
  return w;
}

KANEXPR_ENGINE bool wheel_builder::is_right(std::string_view asking, const wheel_on_ground& wheel) {
  if (!owns_wheel(asking, wheel)) return false;
  const mechanics::contents held(*m_.g);
  mechanics::load_check by(m_, held);
  wheel.check_with(by, "the wheel");
  return !by.mistake() || checks_.fail({by.mistake().view()});
}

KANEXPR_ENGINE expression wheel_builder::penetration_of(const wheel_on_ground& wheel) {
  if (has_mistake() || !is_right("the penetration of a wheel", wheel)) return m_.zero();
  return wheel.contact(m_).penetration;
}

KANEXPR_ENGINE point_id wheel_builder::contact_point(std::string_view called, const wheel_on_ground& wheel) {
  if (has_mistake() || !is_right(called, wheel)) return {};
  vector down;
  down.add(wheel.other, wheel.contact(m_).lowest);
  const point_id at = points_.offset(called, point_id{wheel.point}, down);
  points_.fixed_in(at, frame_id{wheel.frame});
  return at;
}

} // namespace kanexpr::runtime
