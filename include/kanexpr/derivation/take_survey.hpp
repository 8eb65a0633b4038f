#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/derivation/derived_system.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/mechanics/model/inertial_parameter.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/motion/unit_quaternions.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::derivation {

constexpr bool is_moment_of(const mechanics::body& b, const expression& parameter) {
  for (const mechanics::dyadic::part& part : b.inertia.parts)
    for (int i = 0; i < 3 && part.left == part.right; ++i)
      if (part.value(i, i) == parameter) return true;
  return false;
}

constexpr void survey::take(derived_system& system) {
  take(system.mechanism(), !system.mistake(), system.is_derived() ? &system.equations() : nullptr);
}

constexpr void survey::take(const mechanism& m, bool is_sound, const mechanics::equations* derived) {
  takes_rates_as_speeds = m.derived_by == mechanics::method::lagrange;
  coordinates = m.coordinates.size();
  speeds = m.speeds.size();
  parameters = m.parameters.size();
  inputs = m.inputs.size();
  auxiliary_speeds = m.auxiliary_speeds.size();
  for (const mechanics::body& b : m.bodies) inertial_parameters += mechanics::inertial_parameters_of(b);
  if (symbols() > room) return;
  int next = 0;
  for (const sequence<expression>* list : {&m.coordinates, &m.speeds, &m.parameters, &m.inputs})
    for (const expression& e : *list) names[next++] = m.g->symbol_at(e.node()).called;
  if (!is_sound) return;
  for (int i = 0; i < parameters; ++i)
    for (const mechanics::body& b : m.bodies) {
      is_mass[coordinates + speeds + i] |= b.mass == m.parameters[i];
      is_moment[coordinates + speeds + i] |= !b.effective && is_moment_of(b, m.parameters[i]);
    }
  inertial_values_reader(m, inertial).read();
  for (const sequence<int>& places : mechanics::unit_quaternions(m)) {
    ++quaternions;
    for (int place : places) quaternion_of[place] = quaternions;
  }
  if (derived == nullptr) return;
  constraints = derived->constraints_used().size();
  configuration_constraints = derived->constraints_used().on_configuration.size();
  redundant_constraints = derived->constraints_used().redundant.size();
  for (int i : derived->coordinates().dependent) dependent[i] = true;
  for (int i : derived->speeds().dependent) dependent[coordinates + i] = true;
}

} // namespace kanexpr::derivation
