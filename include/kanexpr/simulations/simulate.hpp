#pragma once

#include <kanexpr/simulations/compiled_system.hpp>
#include <kanexpr/simulations/simulation.hpp>

#ifndef KANEXPR_COMPILED_SIMULATIONS
#include <kanexpr/simulations/constraints/constraint_manifold.hpp>
#include <kanexpr/simulations/integration.hpp>

#endif

namespace kanexpr {

namespace simulations {

/// Simulates a system over a time span; `state` contains the initial state and receives the final one.
template <integrator by>
simulation_end run(system_interface& moved, double* state, const time_span& span, const settings& options);

template <class System>
settings settings_of(const simulation_options<System>& o) {
  settings s{o.relative_tolerance,
             o.absolute_tolerance,
             o.absolute_tolerances,
             o.output_every,
             o.output_times,
             o.dense,
             o.keep,
             static_cast<bool>(o.each_sample),
             o.first_step,
             o.least_step,
             o.greatest_step,
             o.most_steps,
             o.analytic_jacobian,
             {},
             o.progress,
             o.inputs.mistake().view(),
             o.inputs.depends_on_state(),
             o.inputs.constants().has_value(),
             sizeof(sample<System>),
             o.guesses_dependent};
  for (const event<System>& e : o.events)
    s.events.push_back(
        {e.name, static_cast<int>(e.direction), static_cast<bool>(e.value), static_cast<bool>(e.handler)});
  return s;
}

} // namespace simulations

/// Simulates a system from a state over a time span: `simulate<System>({{q, 0.1}, {u, 0}}, {{m, 1}, {g,
/// 9.81}}, {0, 10})`. Dependent coordinates and speeds are solved for at the start and kept on the
/// constraints; a given value that contradicts the constraints is a failure, unless the options declare it a
/// guess. The result holds the cause of a failure and everything computed until then; no exception is thrown.
///
/// Select a different method as in `simulate<System, integrator::bdf>(…)`.
template <class System, integrator by = integrator::adams>
simulation<System> simulate(const given_state<System>& x, const given_parameters<System>& p, time_span span,
                            const simulation_options<System>& options = {}) {
  simulation<System> result;
  result.trajectory = trajectory<System>(p.values);
  result.time = span.from;
  result.state = x.values;
  result.failure = (p.mistake ? p.mistake : x.mistake).view();
  if (!result.failure.empty()) return result;
  simulations::compiled_system<System, by> moved(p.values, options, result.trajectory);
  simulations::settings asked = simulations::settings_of(options);
  asked.is_left_out.assign(x.is_left_out.begin(), x.is_left_out.end());
  static_cast<simulation_end&>(result) = simulations::run<by>(moved, result.state.data(), span, asked);
  return result;
}

} // namespace kanexpr
