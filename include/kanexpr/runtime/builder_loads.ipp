#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/mechanics/checks/check_torsional_spring.hpp>
#include <kanexpr/mechanics/loads/loads.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>

/// The loads of a builder.
namespace kanexpr::runtime {

KANEXPR_ENGINE void builder::force(point_id at, const vector& value) {
  if (inspect_.present(at, "a force") && inspect_.own(value, "a force"))
    system_.loads.forces.push({place(at), value});
}

KANEXPR_ENGINE void builder::torque(frame_id on, const vector& value) {
  if (inspect_.present(on, "a torque") && inspect_.own(value, "a torque"))
    system_.loads.torques.push({place(on), value});
}

KANEXPR_ENGINE void builder::force_between(point_id at, point_id other, const vector& value) {
  if (both(at, other, "a force") && inspect_.own(value, "a force"))
    system_.loads.forces.push({place(at), value, place(other)});
}

KANEXPR_ENGINE void builder::torque_between(frame_id on, frame_id other, const vector& value) {
  if (both(on, other, "a torque") && inspect_.own(value, "a torque"))
    system_.loads.torques.push({place(on), value, place(other)});
}

KANEXPR_ENGINE void builder::gravity(const vector& acceleration) {
  if (system_.loads.has_gravity)
    inspect_.fail({"gravity is specified twice"});
  else if (inspect_.own(acceleration, "gravity"))
    system_.loads.has_gravity = true, system_.loads.gravity = acceleration;
}

KANEXPR_ENGINE void builder::potential_energy(expression energy) {
  if (!inspect_.own(energy, "a potential energy")) return;
  if (energy.is_zero()) inspect_.fail({"a potential energy is zero"});
  system_.loads.potential_energies.push({energy});
}

KANEXPR_ENGINE void builder::spring(point_id at, point_id other, expression stiffness,
                                    expression natural_length) {
  if (both(at, other, "a spring") && inspect_.own({stiffness, natural_length}, "a spring"))
    mechanics::add_spring(system_.loads.spring_dampers, place(at), place(other), stiffness, natural_length);
}

KANEXPR_ENGINE void builder::spring(point_id at, point_id other, expression stiffness) {
  spring(at, other, stiffness, m_.zero());
}

KANEXPR_ENGINE void builder::damper(point_id at, point_id other, expression damping) {
  if (both(at, other, "a damper") && inspect_.own(damping, "a damper"))
    mechanics::add_damper(system_.loads.spring_dampers, place(at), place(other), damping);
}

KANEXPR_ENGINE void builder::torsional_spring(expression angle, expression stiffness, expression rest) {
  constexpr std::string_view whose = "a torsional spring";
  if (!inspect_.own(angle, whose) || !inspect_.own({stiffness, rest}, whose)) return;
  if (const sentence found = mechanics::check_torsional_spring(m_, angle, stiffness, rest, whose))
    inspect_.fail({found.view()});
  else
    system_.loads.potential_energies.push(mechanics::torsional_spring(angle, stiffness, rest));
}

KANEXPR_ENGINE void builder::torsional_spring(expression angle, expression stiffness) {
  torsional_spring(angle, stiffness, m_.zero());
}

KANEXPR_ENGINE void builder::torsional_damper(frame_id on, frame_id other, expression damping) {
  if (both(on, other, "a torsional damper") && inspect_.own(damping, "a torsional damper"))
    system_.loads.torsional_dampers.push({place(on), place(other), damping});
}

} // namespace kanexpr::runtime
