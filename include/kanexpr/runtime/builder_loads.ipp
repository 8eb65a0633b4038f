#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/derivation/read/value.hpp>
#include <kanexpr/mechanics/checks/check_torsional_spring.hpp>
#include <kanexpr/mechanics/loads/loads.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/fixed.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/runtime/system_expressions.ipp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>

namespace kanexpr::runtime {

KANEXPR_ENGINE void builder::force(point_id at, const vector& value) {
  if (checks_.owns("a force", at, value)) system_.loads.forces.push({place(at), value});
}

KANEXPR_ENGINE void builder::torque(frame_id on, const vector& value) {
  if (checks_.owns("a torque", on, value)) system_.loads.torques.push({place(on), value});
}

KANEXPR_ENGINE void builder::force_between(point_id at, point_id other, const vector& value) {
  if (checks_.owns("a force", at, other, value)) system_.loads.forces.push({place(at), value, place(other)});
}

KANEXPR_ENGINE void builder::torque_between(frame_id on, frame_id other, const vector& value) {
  if (checks_.owns("a torque", on, other, value))
    system_.loads.torques.push({place(on), value, place(other)});
}

KANEXPR_ENGINE void builder::gravity(const vector& acceleration) {
  if (system_.loads.has_gravity)
    checks_.fail({"gravity is specified twice"});
  else if (checks_.owns("gravity", acceleration))
    system_.loads.has_gravity = true, system_.loads.gravity = acceleration;
}

KANEXPR_ENGINE void builder::potential_energy(expression energy) {
  if (!checks_.owns("a potential energy", energy)) return;
  if (energy.is_zero()) checks_.fail({"a potential energy is zero"});
  system_.loads.potential_energies.push({energy});
}

KANEXPR_ENGINE void builder::spring(point_id at, point_id other, expression stiffness,
                                    expression natural_length) {
  if (checks_.owns("a spring", at, other, stiffness, natural_length))
    mechanics::add_spring(system_.loads.spring_dampers, place(at), place(other), stiffness, natural_length);
}

KANEXPR_ENGINE void builder::damper(point_id at, point_id other, expression damping) {
  if (checks_.owns("a damper", at, other, damping))
    mechanics::add_damper(system_.loads.spring_dampers, place(at), place(other), damping);
}

KANEXPR_ENGINE void builder::torsional_spring(expression angle, expression stiffness, expression rest) {
  constexpr std::string_view whose = "a torsional spring";
  if (!checks_.owns(whose, angle, stiffness, rest)) return;
  if (const sentence found = mechanics::check_torsional_spring(m_, angle, stiffness, rest, whose))
    checks_.fail({found.view()});
  else
    system_.loads.potential_energies.push(mechanics::torsional_spring(angle, stiffness, rest));
}

KANEXPR_ENGINE void builder::torsional_damper(frame_id on, frame_id other, expression damping) {
  if (checks_.owns("a torsional damper", on, other, damping))
    system_.loads.torsional_dampers.push({place(on), place(other), damping});
}

} // namespace kanexpr::runtime
