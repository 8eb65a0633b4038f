#pragma once

#include <kanexpr/base/name.hpp>
#include <kanexpr/base/sentence.hpp>
#include <kanexpr/derivation/read/value.hpp>
#include <kanexpr/mechanics/checks/check_torsional_spring.hpp>
#include <kanexpr/mechanics/loads/bushing.hpp>
#include <kanexpr/mechanics/loads/loads.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/fixed.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/motion/known_motion.hpp>
#include <kanexpr/mechanics/motion/observe.hpp>
#include <kanexpr/runtime/building/load_builder.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>
#include <vector>

namespace kanexpr::runtime {

KANEXPR_ENGINE void load_builder::force(point_id at, const vector& value) {
  if (checks_.owns("a force", at, value)) system_.loads.forces.push({place(at), value});
}

KANEXPR_ENGINE void load_builder::torque(frame_id on, const vector& value) {
  if (checks_.owns("a torque", on, value)) system_.loads.torques.push({place(on), value});
}

KANEXPR_ENGINE void load_builder::force_between(point_id at, point_id other, const vector& value) {
  if (checks_.owns("a force", at, other, value)) system_.loads.forces.push({place(at), value, place(other)});
}

KANEXPR_ENGINE void load_builder::torque_between(frame_id on, frame_id other, const vector& value) {
  if (checks_.owns("a torque", on, other, value))
    system_.loads.torques.push({place(on), value, place(other)});
}

KANEXPR_ENGINE void load_builder::gravity(const vector& acceleration) {
  if (system_.loads.has_gravity)
    checks_.fail({"gravity is specified twice"});
  else if (checks_.owns("gravity", acceleration))
    system_.loads.has_gravity = true, system_.loads.gravity = acceleration;
}

KANEXPR_ENGINE void load_builder::potential_energy(expression energy) {
  if (!checks_.owns("a potential energy", energy)) return;
  if (energy.is_zero()) checks_.fail({"a potential energy is zero"});
  system_.loads.potential_energies.push({energy});
}

KANEXPR_ENGINE void load_builder::drag(point_id at, const number_or_expression& coefficient,
                                       mechanics::known_motion& known) {
  if (coefficient.is_whole_zero()) {
    checks_.fail_integer_zero("the coefficient of a drag is 0");
    return;
  }
  const expression c = as_expression(coefficient);
  if (!is_own(known, "a drag") || !checks_.owns("a drag", at, c)) return;
  const vector v = mechanics::velocity_of_point(known.moving(), place(at));
  const expression speed = sqrt(derivation::dot(m_, v, v));
  const expression scale = -(c * speed);
  system_.loads.forces.push({place(at), scale * v});
}

KANEXPR_ENGINE pulling_load load_builder::spring(point_id at, point_id other, expression stiffness,
                                                 expression natural_length) {
  if (!checks_.owns("a spring", at, other, stiffness, natural_length)) return {};
  mechanics::add_spring(system_.loads.spring_dampers, place(at), place(other), stiffness, natural_length);
  return system_.loads.spring_dampers.back();
}

KANEXPR_ENGINE pulling_load load_builder::damper(point_id at, point_id other, expression damping) {
  if (!checks_.owns("a damper", at, other, damping)) return {};
  mechanics::add_damper(system_.loads.spring_dampers, place(at), place(other), damping);
  return mechanics::damper_alone(place(at), place(other), damping);
}

KANEXPR_ENGINE void load_builder::torsional_spring(expression angle, expression stiffness, expression rest) {
  constexpr std::string_view whose = "a torsional spring";
  if (!checks_.owns(whose, angle, stiffness, rest)) return;
  if (const sentence found = mechanics::check_torsional_spring(m_, angle, stiffness, rest, whose))
    checks_.fail({found.view()});
  else
    system_.loads.potential_energies.push(mechanics::torsional_spring(angle, stiffness, rest));
}

KANEXPR_ENGINE void load_builder::torsional_damper(frame_id on, frame_id other, expression damping) {
  if (checks_.owns("a torsional damper", on, other, damping))
    system_.loads.torsional_dampers.push({place(on), place(other), damping});
}

KANEXPR_ENGINE void load_builder::bushing(frame_id on, point_id at, frame_id base, point_id base_point,
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
