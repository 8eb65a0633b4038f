#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/loads/add_path_load.hpp>
#include <kanexpr/mechanics/loads/bushing.hpp>
#include <kanexpr/mechanics/loads/pathway.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/fixed.hpp>
#include <kanexpr/mechanics/model/orientation.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>
#include <vector>

namespace kanexpr::runtime {

KANEXPR_ENGINE pathway builder::through(const std::vector<point_id>& points) {
  pathway p;
  if (points.size() < 2) checks_.fail({"a pathway passes through fewer than two points"});
  for (const point_id each : points)
    if (checks_.owns("a pathway", each)) p.points.push(place(each));
  return p;
}

KANEXPR_ENGINE pathway builder::given_length(expression length) {
  pathway p;
  p.form = mechanics::pathway_form::given_length;
  if (checks_.owns("the length of a pathway", length)) p.length = length;
  return p;
}

KANEXPR_ENGINE pathway builder::around_surface(mechanics::pathway_form form, frame_id in, point_id center,
                                               const vector& axis, expression size, end_of_path first,
                                               end_of_path last, wrapping sense) {
  pathway p;
  p.form = form;
  if (!checks_.owns("a pathway", in, center, axis, size, first.point, last.point)) return p;
  p.points = {place(first.point), place(last.point)};
  p.frame = place(in), p.center = place(center);
  p.surface.axis = mechanics::express(m_, axis, place(in));
  p.surface.size = size;
  p.surface.sense = sense == wrapping::counterclockwise ? 1 : -1;
  p.surface.first_is_on_surface = first.is_on_surface, p.surface.last_is_on_surface = last.is_on_surface;
  if (form == mechanics::pathway_form::around_sphere) return p;
  if (p.surface.axis.is_zero()) checks_.fail({"a pathway is wrapped around an axis of zero length"});
  if (!mechanics::is_fixed(p.surface.axis))
    checks_.fail({"a pathway is wrapped around an axis that is not fixed in ", name_of(in)});
  p.surface.axis = mechanics::unit_along(p.surface.axis);
  return p;
}

KANEXPR_ENGINE pathway builder::around_cylinder(frame_id in, point_id on_axis, const vector& axis,
                                                expression radius, end_of_path first, end_of_path last,
                                                wrapping sense) {
  return around_surface(mechanics::pathway_form::around_cylinder, in, on_axis, axis, radius, first, last,
                        sense);
}

KANEXPR_ENGINE pathway builder::around_sphere(point_id center, expression radius, end_of_path first,
                                              end_of_path last) {
  return around_surface(mechanics::pathway_form::around_sphere, inertial_frame(), center, {}, radius, first,
                        last, wrapping::counterclockwise);
}

KANEXPR_ENGINE pathway builder::around_cone(frame_id in, point_id tip, const vector& axis, expression angle,
                                            end_of_path first, end_of_path last, wrapping sense) {
  return around_surface(mechanics::pathway_form::around_cone, in, tip, axis, angle, first, last, sense);
}

KANEXPR_ENGINE expression builder::length_of(const pathway& along) {
  if (along.points.empty() && !along.length.is_given()) checks_.fail({"a pathway has no points"});
  if (mistake() || !owns_pathway("the length of a pathway", along)) return m_.zero();
  if (const sentence found = along.find_mistake(m_, "pathway")) checks_.fail({found.view()});
  return mistake() ? m_.zero() : along.length_in(m_);
}

/// Whether a pathway, which may be that of another builder, refers only to parts of this one.
KANEXPR_ENGINE bool builder::owns_pathway(std::string_view whose, const pathway& along) {
  for (const int point : along.points)
    if (!checks_.owns(whose, point_id{point})) return false;
  if (along.form == mechanics::pathway_form::given_length) return checks_.owns(whose, along.length);
  if (!along.is_around_surface()) return true;
  return checks_.owns(whose, frame_id{along.frame}, point_id{along.center}, along.surface.size,
                      along.surface.axis);
}

/// A pathway without points or length is one whose mistake has been reported.
KANEXPR_ENGINE bool builder::owns_path_load(std::string_view whose, const pathway& along,
                                            const base::sequence<expression>& terms) {
  if (mistake()) return false;
  if (along.points.empty() && !along.length.is_given())
    return checks_.fail({whose, " acts along a pathway that has no points"});
  return owns_pathway(whose, along) && checks_.owns(whose, terms);
}

KANEXPR_ENGINE void builder::force_along(const pathway& along, expression tension) {
  if (owns_path_load("a force along a pathway", along, {tension}))
    mechanics::add_force_along(system_.loads, along, tension);
}

KANEXPR_ENGINE void builder::linear_spring(const pathway& along, expression stiffness,
                                           expression natural_length) {
  if (owns_path_load("a linear spring", along, {stiffness, natural_length}))
    mechanics::add_spring_along(system_.loads, along, stiffness, m_.zero(), natural_length);
}

KANEXPR_ENGINE void builder::cubic_spring(const pathway& along, expression k, expression k3,
                                          expression natural_length) {
  if (owns_path_load("a cubic spring", along, {k, k3, natural_length}))
    mechanics::add_spring_along(system_.loads, along, k, k3, natural_length);
}

KANEXPR_ENGINE void builder::linear_damper(const pathway& along, expression damping) {
  if (owns_path_load("a linear damper", along, {damping}))
    mechanics::add_damper_along(system_.loads, along, damping);
}

KANEXPR_ENGINE void builder::friction_along(const pathway& along, expression normal_force,
                                            const mechanics::friction_law& law) {
  base::sequence<expression> terms{normal_force};
  for (const expression& e : {law.sliding, law.sticking, law.slip_speed, law.viscous, law.bristles.stiffness,
                              law.bristles.damping, law.bristles.stribeck_speed})
    if (e.is_given()) terms.push(e);
  for (const expression& z : law.bristles.deflections) terms.push(z);
  if (law.has_bristles() && law.bristles.deflections.size() != 1)
    checks_.fail({"the friction along a pathway has ",
                  mechanics::several(law.bristles.deflections.size(), "bristle").view(), ", expected 1"});
  else if (law.needs_coefficient())
    checks_.fail({"a friction along a pathway has no coefficient"});
  else if (law.needs_slip_speed())
    checks_.fail({"a friction along a pathway has no slip speed"});
  else if (owns_path_load("a friction along a pathway", along, terms)) {
    mechanics::add_friction_along(system_.loads, along, normal_force, law);
    mechanics::add_bristles(m_, system_.loads, law);
  }
}

KANEXPR_ENGINE void builder::stop(const pathway& along, expression least, expression greatest,
                                  expression stiffness, expression damping, expression width) {
  if (owns_path_load("a stop", along, {least, greatest, stiffness, damping, width}))
    mechanics::add_stop(system_.loads, along, {least, greatest, stiffness, damping, width});
}

KANEXPR_ENGINE void builder::bushing(frame_id on, point_id at, frame_id base, point_id base_point,
                                     const std::vector<expression>& stiffnesses,
                                     const std::vector<expression>& dampings) {
  if (!checks_.owns("a bushing", on, at, base, base_point)) return;
  if (stiffnesses.size() != 6 || (dampings.size() != 6 && !dampings.empty())) {
    checks_.fail({"expected six stiffnesses and six dampings or none of a bushing, got ",
                  base::counted(static_cast<int>(stiffnesses.size())).view(), " and ",
                  base::counted(static_cast<int>(dampings.size())).view()});
    return;
  }
  mechanics::bushing b;
  b.frame = place(on), b.against = place(base), b.place = place(at), b.base = place(base_point);
  for (const expression& k : stiffnesses) b.stiffness.push(k);
  for (std::size_t i = 0; i < 6; ++i) b.damping.push(dampings.empty() ? m_.zero() : dampings[i]);
  if (checks_.owns("a bushing", b.stiffness, b.damping)) system_.loads.add(b);
}

} // namespace kanexpr::runtime
