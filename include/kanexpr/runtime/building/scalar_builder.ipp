#pragma once

#include <kanexpr/base/name.hpp>
#include <kanexpr/base/sentence.hpp>
#include <kanexpr/mechanics/checks/check.hpp>
#include <kanexpr/mechanics/loads/state_rate.hpp>
#include <kanexpr/mechanics/skeleton/orientation_kinematics.hpp>
#include <kanexpr/runtime/building/scalar_builder.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>

namespace kanexpr::runtime {

KANEXPR_ENGINE void scalar_builder::used_elsewhere(expression parameter_or_input) {
  if (m_.parameters.contains(parameter_or_input) || m_.inputs.contains(parameter_or_input))
    core_.used_elsewhere_.push(parameter_or_input);
  else
    checks_.fail({"the argument of used_elsewhere is neither a parameter nor an input"});
}

KANEXPR_ENGINE expression scalar_builder::prescribed(std::string_view r) {
  base::name called = r;
  const expression value = input(r);
  expression last = value;
  for (int order = 1; order <= 2; ++order) {
    called.append("'");
    checks_.is_unused(called.view());
    const expression rate = m_.input(called);
    m_.prescribed_rates.push({last, rate});
    last = rate;
  }
  return value;
}

KANEXPR_ENGINE void scalar_builder::rates_as_speeds() {
  m_.derived_by = mechanics::method::lagrange;
  checks_.is_before_state_variables("the rates of the coordinates are");
  m_.take_rates_as_speeds();
}

KANEXPR_ENGINE void scalar_builder::lagrangian(expression energy) {
  if (!checks_.owns("the Lagrangian", energy)) return;
  system_.loads.has_lagrangian = true;
  system_.loads.lagrangian = energy;
}

KANEXPR_ENGINE expression scalar_builder::dot(expression e) {
  if (e.belongs_to(*m_.g)) {
    if (const int q = m_.coordinates.find(e); q >= 0)
      return m_.derived_by == mechanics::method::lagrange ? m_.speeds[q] : m_.coordinate_rates[q];
    if (const int u = m_.speeds.find(e); u >= 0) return m_.speed_rates[u];
    for (const mechanics::prescribed_rate& p : m_.prescribed_rates)
      if (p.quantity == e) return p.rate;
  }
  checks_.fail({"the argument of dot is not a coordinate, speed or prescribed quantity"});
  return m_.zero();
}

KANEXPR_ENGINE void scalar_builder::dynamics(expression state_variable, expression rate) {
  const int speed = state_variable.belongs_to(*m_.g) ? m_.speeds.find(state_variable) : -1;
  if (speed < m_.speeds_of_motion()) {
    checks_.fail({"the first argument of dynamics is not a state variable"});
    return;
  }
  if (!checks_.owns("the rate of a state variable", rate)) return;
  const mechanics::solved_state_rate solved =
      mechanics::solve_for_state_rate(m_, speed, m_.speed_rates[speed] - rate);
  if (solved.mistake)
    checks_.fail({solved.mistake.view()});
  else
    system_.loads.state_rates.push(solved.found);
}

KANEXPR_ENGINE void scalar_builder::kinematics_of(frame_id frame, frame_id reference) {
  if (!checks_.owns("kinematics_of", frame, reference)) return;
  if (const sentence found = mechanics::check_orientation_kinematics(m_, place(frame), place(reference))) {
    checks_.fail({found.view()});
    return;
  }
  for (const expression& e : mechanics::orientation_kinematics(m_, place(frame), place(reference)))
    m_.kinematics.push(e);
}

} // namespace kanexpr::runtime
