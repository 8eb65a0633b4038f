#pragma once

#include <kanexpr/derive/derived_system.hpp>
#include <kanexpr/derive/survey.hpp>
#include <kanexpr/mechanics/motion/unit_quaternions.hpp>

namespace kanexpr::deriving {

constexpr void survey::take(derived_system& system) {
  const mechanism& m = system.mechanism();
  takes_rates_as_speeds = m.derived_by == mechanics::method::lagrange;
  coordinates = m.coordinates.size();
  speeds = m.speeds.size();
  parameters = m.parameters.size();
  inputs = m.inputs.size();
  auxiliary_speeds = m.auxiliary_speeds.size();
  if (symbols() > room) return;
  int next = 0;
  for (const sequence<expression>* list : {&m.coordinates, &m.speeds, &m.parameters, &m.inputs})
    for (const expression& e : *list) names[next++] = m.g->symbol_at(e.node()).called;
  if (system.mistake()) return;
  for (const sequence<int>& places : mechanics::unit_quaternions(m)) {
    ++quaternions;
    for (int place : places) quaternion_of[place] = quaternions;
  }
  if (!system.is_derived()) return;
  mechanics::equations& e = system.equations();
  constraints = e.constraints_used().size();
  configuration_constraints = e.constraints_used().on_configuration.size();
  for (int i : e.coordinates().dependent) dependent[i] = true;
  for (int i : e.speeds().dependent) dependent[coordinates + i] = true;
}

} // namespace kanexpr::deriving
