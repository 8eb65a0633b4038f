#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/mechanics/checks/check.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/position.hpp>
#include <kanexpr/runtime/building/point_builder.hpp>

#include <string_view>

namespace kanexpr::runtime {

KANEXPR_ENGINE point_id point_builder::origin(std::string_view called) {
  return checks_.is_new("points", called, m_.points) ? point_id{m_.points.push({.called = called})}
                                                     : point_id{};
}

KANEXPR_ENGINE point_id point_builder::offset(std::string_view called, point_id parent,
                                              const vector& from_parent) {
  if (!checks_.is_new("points", called, m_.points) || !checks_.owns(called, parent, from_parent)) return {};
  return point_id{m_.points.push({.called = called, .parent = place(parent), .offset = from_parent})};
}

KANEXPR_ENGINE void point_builder::fixed_in(point_id point, frame_id frame) {
  if (checks_.owns("a fixed point", frame) && is_motion_undeclared(point))
    m_.points[place(point)].fixed_in = place(frame);
}

KANEXPR_ENGINE vector point_builder::position_of(point_id point, point_id from) {
  if (!checks_.owns("a position", point, from)) return {};
  if (const sentence unknown = mechanics::check_position(m_, place(point), place(from))) {
    checks_.fail({unknown.view()});
    return {};
  }
  return mechanics::position_from(m_, place(from), place(point));
}

KANEXPR_ENGINE bool point_builder::is_motion_undeclared(point_id p) {
  if (!checks_.owns("a declared motion", p)) return false;
  const mechanics::point& at = m_.points[place(p)];
  if (at.parent == mechanics::none)
    return checks_.fail(
        {"point ", name_of(p), " is an origin, fixed in the inertial frame, but has a declared motion"});
  if (at.fixed_in != mechanics::none || at.has_declared_velocity())
    return checks_.fail({"point ", name_of(p), " has two declared motions"});
  return true;
}

KANEXPR_ENGINE bool point_builder::may_declare_velocity(point_id point, frame_id reference,
                                                        const vector& velocity) {
  return checks_.owns("a declared velocity", reference) && is_motion_undeclared(point) &&
         checks_.owns(name_of(point), velocity);
}

KANEXPR_ENGINE void point_builder::velocity(point_id point, frame_id reference, const vector& value) {
  if (may_declare_velocity(point, reference, value))
    m_.points[place(point)].declare_velocity(place(reference), value,
                                             place(reference) != mechanics::mechanism::inertial);
}

KANEXPR_ENGINE void point_builder::velocity_apart_from_position(point_id point, frame_id reference,
                                                                const vector& value) {
  if (!may_declare_velocity(point, reference, value)) return;
  m_.points[place(point)].declare_velocity(place(reference), value,
                                           place(reference) != mechanics::mechanism::inertial);
  m_.points[place(point)].moves_apart = true;
}

KANEXPR_ENGINE void point_builder::velocity_from_parent(point_id point, frame_id reference,
                                                        const vector& value) {
  if (may_declare_velocity(point, reference, value))
    m_.points[place(point)].declare_velocity(place(reference), value, true);
}

} // namespace kanexpr::runtime
