#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/loads/add_bristles.hpp>
#include <kanexpr/mechanics/loads/add_path_load.hpp>
#include <kanexpr/mechanics/loads/bushing.hpp>
#include <kanexpr/mechanics/loads/observed_motion.hpp>
#include <kanexpr/mechanics/loads/pathway.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/fixed.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/orientation.hpp>
#include <kanexpr/mechanics/motion/known_motion.hpp>
#include <kanexpr/runtime/building/pathway_builder.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

namespace kanexpr::runtime {

KANEXPR_ENGINE pathway pathway_builder::through(const std::vector<point_id>& points) {
  pathway p;
  if (points.size() < 2) checks_.fail({"a pathway passes through fewer than two points"});
  for (const point_id each : points)
    if (checks_.owns("a pathway", each)) p.points.push(place(each));
  return p;
}

KANEXPR_ENGINE pathway pathway_builder::given_length(expression length) {
  pathway p;
  p.form = mechanics::pathway_form::given_length;
  if (checks_.owns("the length of a pathway", length)) p.length = length;
  return p;
}

KANEXPR_ENGINE pathway pathway_builder::around_surface(mechanics::pathway_form form, frame_id in,
                                                       point_id center, const vector& axis, expression size,
                                                       end_of_path first, end_of_path last, wrapping sense) {
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

KANEXPR_ENGINE pathway pathway_builder::around_cylinder(frame_id in, point_id on_axis, const vector& axis,
                                                        expression radius, end_of_path first,
                                                        end_of_path last, wrapping sense) {
  return around_surface(mechanics::pathway_form::around_cylinder, in, on_axis, axis, radius, first, last,
                        sense);
}

KANEXPR_ENGINE pathway pathway_builder::around_sphere(point_id center, expression radius, end_of_path first,
                                                      end_of_path last) {
  return around_surface(mechanics::pathway_form::around_sphere, frame_id{mechanics::mechanism::inertial},
                        center, {}, radius, first, last, wrapping::counterclockwise);
}

KANEXPR_ENGINE pathway pathway_builder::around_cone(frame_id in, point_id tip, const vector& axis,
                                                    expression angle, end_of_path first, end_of_path last,
                                                    wrapping sense) {
  return around_surface(mechanics::pathway_form::around_cone, in, tip, axis, angle, first, last, sense);
}

KANEXPR_ENGINE expression pathway_builder::length_of(const pathway& along) {
  if (along.points.empty() && !along.length.is_given()) checks_.fail({"a pathway has no points"});
  if (has_mistake() || !checks_.owns("the length of a pathway", along)) return m_.zero();
  if (const sentence found = along.find_mistake(m_, "pathway")) checks_.fail({found.view()});
  return has_mistake() ? m_.zero() : along.length_in(m_);
}

KANEXPR_ENGINE pulling_load pathway_builder::force_along(const pathway& along, expression tension) {
  if (!checks_.owns_path_load("a force along a pathway", along, {tension})) return {};
  mechanics::add_force_along(system_.loads, along, tension);
  return mechanics::load_in<mechanics::path_load>(system_.loads.elements.back());
}

/// The last spring along a pathway, which is straight if it is among those between two points.
KANEXPR_ENGINE pulling_load pathway_builder::add_spring(const pathway& along, expression k, expression k3,
                                                        expression natural_length) {
  mechanics::add_spring_along(system_.loads, along, k, k3, natural_length);
  if (mechanics::is_straight(along) && k3.is_zero()) return system_.loads.spring_dampers.back();
  return mechanics::load_in<mechanics::path_load>(system_.loads.elements.back());
}

KANEXPR_ENGINE pulling_load pathway_builder::linear_spring(const pathway& along, expression stiffness,
                                                           expression natural_length) {
  if (!checks_.owns_path_load("a linear spring", along, {stiffness, natural_length})) return {};
  return add_spring(along, stiffness, m_.zero(), natural_length);
}

KANEXPR_ENGINE pulling_load pathway_builder::cubic_spring(const pathway& along, expression k, expression k3,
                                                          expression natural_length) {
  if (!checks_.owns_path_load("a cubic spring", along, {k, k3, natural_length})) return {};
  return add_spring(along, k, k3, natural_length);
}

KANEXPR_ENGINE pulling_load pathway_builder::linear_damper(const pathway& along, expression damping) {
  if (!checks_.owns_path_load("a linear damper", along, {damping})) return {};
  mechanics::add_damper_along(system_.loads, along, damping);
  if (!mechanics::is_straight(along))
    return mechanics::load_in<mechanics::path_load>(system_.loads.elements.back());
  return mechanics::damper_alone(along.points[0], along.points[1], damping);
}

KANEXPR_ENGINE pulling_load pathway_builder::friction_along(const pathway& along, expression normal_force,
                                                            const mechanics::friction_law& law) {
  base::sequence<expression> terms{normal_force};
  for (const expression& e : {law.sliding, law.sticking, law.slip_speed, law.viscous, law.bristles.stiffness,
                              law.bristles.damping, law.bristles.stribeck_speed})
    if (e.is_given()) terms.push(e);
  for (const expression& z : law.bristles.deflections) terms.push(z);
  if (law.has_bristles() && law.bristles.deflections.size() != 1)
    checks_.fail({"the friction along a pathway has ",
                  mechanics::several(law.bristles.deflections.size(), "bristle").view(), ", expected 1"});
  else if (!law)
    checks_.fail({"a friction along a pathway has no law"});
  else if (law.needs_coefficient())
    checks_.fail({"a friction along a pathway has no coefficient"});
  else if (law.needs_slip_speed())
    checks_.fail({"a friction along a pathway has no slip speed"});
  else if (checks_.owns_path_load("a friction along a pathway", along, terms)) {
    mechanics::add_friction_along(system_.loads, along, normal_force, law);
    mechanics::add_bristles(m_, system_.loads, law);
    return mechanics::load_in<mechanics::path_load>(system_.loads.elements.back());
  }
  return {};
}

KANEXPR_ENGINE pulling_load pathway_builder::stop(const pathway& along, expression least, expression greatest,
                                                  expression stiffness, expression damping,
                                                  expression width) {
  if (!checks_.owns_path_load("a stop", along, {least, greatest, stiffness, damping, width})) return {};
  mechanics::add_stop(system_.loads, along, {least, greatest, stiffness, damping, width});
  return mechanics::load_in<mechanics::path_load>(system_.loads.elements.back());
}

KANEXPR_ENGINE bool pathway_builder::owns_load(const mechanics::spring_damper& load) {
  return checks_.owns("the load of a tension", point_id{load.point}, point_id{load.against}, load.stiffness,
                      load.damping);
}

KANEXPR_ENGINE bool pathway_builder::owns_load(const mechanics::path_load& load) {
  return checks_.owns("the load of a tension", load.along, load.terms);
}

KANEXPR_ENGINE bool pathway_builder::owns_load(const mechanics::muscle& load) {
  return checks_.owns("the load of a tension", load.along, load.activation);
}

KANEXPR_ENGINE expression pathway_builder::tension_of(const pulling_load& load,
                                                      mechanics::known_motion& known) {
  if (!is_own(known, "the tension of a load")) return m_.zero();
  return std::visit(
      [&](const auto& given) {
        if constexpr (std::is_same_v<decltype(given), const std::monostate&>) {
          checks_.fail({"the tension is requested of a load that was not added to the builder"});
          return m_.zero();
        } else {
          if (!owns_load(given)) return m_.zero();
          mechanics::observed_motion on(known.moving());
          return given.tension(on);
        }
      },
      load);
}

} // namespace kanexpr::runtime
