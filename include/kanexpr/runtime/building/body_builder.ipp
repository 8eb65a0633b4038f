#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/mechanics/model/fixed.hpp>
#include <kanexpr/mechanics/model/position.hpp>
#include <kanexpr/mechanics/model/rotor.hpp>
#include <kanexpr/runtime/building/body_builder.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>

namespace kanexpr::runtime {

KANEXPR_ENGINE void body_builder::particle(std::string_view called, point_id at, expression mass) {
  if (is_new_body(called) && checks_.owns(called, at, mass))
    m_.bodies.push({.called = called, .center = place(at), .mass = mass});
}

KANEXPR_ENGINE void body_builder::rigid_body(std::string_view called, point_id center, frame_id frame,
                                             expression mass, const dyadic& inertia, point_id about) {
  if (is_new_body(called) && checks_.owns(called, center, frame, mass, inertia, about))
    m_.bodies.push({.called = called,
                    .center = place(center),
                    .frame = place(frame),
                    .mass = mass,
                    .inertia = inertia,
                    .about = place(about)});
}

KANEXPR_ENGINE void body_builder::mark_body(std::string_view body, bool mechanics::body::* mark,
                                            std::string_view whose) {
  for (mechanics::body& b : m_.bodies)
    if (b.called.view() == body) {
      b.*mark = true;
      return;
    }
  checks_.fail({whose, " refers to body ", body, ", which does not exist"});
}

KANEXPR_ENGINE void body_builder::changing_inertia(std::string_view body) {
  mark_body(body, &mechanics::body::inertia_changes, "changing_inertia");
}

KANEXPR_ENGINE void body_builder::effective_inertia(std::string_view body) {
  mark_body(body, &mechanics::body::effective, "effective_inertia");
}

KANEXPR_ENGINE void body_builder::rotor(std::string_view called, expression angle,
                                        const number_or_expression& inertia,
                                        const number_or_expression& gear_ratio) {
  if (inertia.is_whole_zero() || gear_ratio.is_whole_zero()) {
    const sentence whose({"the inertia or the gear ratio of rotor ", called, " is 0"});
    checks_.fail_integer_zero(whose.view());
    return;
  }
  const expression moment = as_expression(inertia), ratio = as_expression(gear_ratio);
  const sentence whose({"rotor ", called});
  if (!checks_.owns(whose.view(), angle, moment, ratio) || !is_new_body(called)) return;
  if (!mechanics::is_fixed(moment) || !mechanics::is_fixed(ratio))
    checks_.fail({"the inertia or the gear ratio of rotor ", called,
                  " changes; they may contain only numbers and parameters"});
  else if (m_.points.empty())
    checks_.fail({"rotor ", called, " is added before any point"});
  else if (checks_.is_new("frames", called, m_.frames))
    mechanics::add_rotor(m_, called, mechanics::origin_of(m_, 0), ratio * angle, moment);
}

} // namespace kanexpr::runtime
