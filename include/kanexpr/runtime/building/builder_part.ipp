#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/mechanics/loads/contact_geometry.hpp>
#include <kanexpr/mechanics/loads/wheel_on_ground.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/runtime/building/builder_part.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>
#include <variant>

namespace kanexpr::runtime {

KANEXPR_ENGINE expression builder_part::constant(given_number value) {
  if (value.is_whole_zero()) checks_.fail_integer_zero("the argument of number is 0");
  if (!symbolic::is_finite(value.value())) checks_.fail({"the argument of number is not finite"});
  return m_.number(value.value());
}

KANEXPR_ENGINE expression builder_part::as_expression(const number_or_expression& given) {
  if (const given_number* value = std::get_if<given_number>(&given.held())) return constant(value->value());
  return std::get<expression>(given.held());
}

KANEXPR_ENGINE expression builder_part::as_nonzero(const number_or_expression& given, std::string_view what) {
  if (given.is_whole_zero()) checks_.fail_integer_zero(sentence({what, " is 0"}).view());
  return as_expression(given);
}

KANEXPR_ENGINE bool builder_part::not_all_zero(std::initializer_list<const number_or_expression*> given,
                                               std::string_view whose) {
  for (const number_or_expression* each : given)
    if (!each->is_whole_zero()) return true;
  return checks_.fail_integer_zero(whose);
}

KANEXPR_ENGINE bool builder_part::is_new_body(std::string_view called) {
  return checks_.is_new("bodies", called, m_.bodies) && checks_.is_new("bodies", called, m_.flexible_bodies);
}

KANEXPR_ENGINE bool builder_part::is_own(const mechanics::known_motion& known, std::string_view requested) {
  return known.skeleton_used().model == &m_ ||
         checks_.fail({requested, " is requested for the motion of a different builder"});
}

KANEXPR_ENGINE bool builder_part::owns_wheel(std::string_view whose,
                                             const mechanics::wheel_on_ground& wheel) {
  if (!wheel.radius.is_given()) return checks_.fail({whose, " is on a wheel that has no radius"});
  const auto is_owned = [&](const mechanics::components& v) {
    return !v.x.is_given() || checks_.owns(whose, v);
  };
  for (const expression& e : {wheel.radius, wheel.tube, wheel.conicity, wheel.head, wheel.height})
    if (e.is_given() && !checks_.owns(whose, e)) return false;
  return checks_.owns(whose, point_id{wheel.point}, point_id{wheel.against}, frame_id{wheel.frame},
                      frame_id{wheel.other}, frame_id{wheel.axis_frame}) &&
         is_owned(wheel.axis) && is_owned(wheel.normal) && is_owned(wheel.along);
}

KANEXPR_ENGINE bool builder_part::set_direction(mechanics::components& unit, int& frame, const vector& given,
                                                std::string_view whose) {
  if (!checks_.owns(whose, given)) return false;
  const mechanics::contact_direction d = mechanics::contact_direction_of(m_, given);
  unit = d.unit, frame = d.frame;
  return d.mistake.empty() || checks_.fail({"a direction of ", whose, d.mistake});
}

} // namespace kanexpr::runtime
