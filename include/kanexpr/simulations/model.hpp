#pragma once

/// Simulation of run-time models and of builders. Link kanexpr::simulate.

#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/simulations/interpreted_system.hpp>
#include <kanexpr/simulations/simulate.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <concepts>
#include <memory>
#include <string>
#include <utility>

namespace kanexpr {

namespace runtime {
class builder;
}
model derive(const runtime::builder& built);

/// Simulates a model from a state over a time span, as `simulate<System>` does, with symbols given by name:
/// `simulate(m, {{"q", 0.1}, {"u", 0}}, {{"m", 1}, {"g", 9.81}}, {0, 10})`.
///
/// Select a different method as in `simulate<integrator::bdf>(m, …)`. No other thread may use the model
/// during the simulation.
template <integrator by = integrator::adams>
simulation<model> simulate(model m, given_state<model> x, given_parameters<model> p, time_span span,
                           const simulation_options<model>& options = {}) {
  simulation<model> result;
  result.time = span.from;
  result.failure = simulations::check_model(m);
  if (!result.failure.empty()) return result;
  const std::shared_ptr<const derivation::survey> known = m.known();
  input_source<model> inputs = options.inputs;
  x.read(known), p.read(known), inputs.read(known);
  result.trajectory = trajectory<model>(m, p.values);
  result.state = x.values;
  result.failure = (p.mistake ? p.mistake : x.mistake).view();
  if (!result.failure.empty()) return result;
  simulations::interpreted_system moved(m, *known, by, p.values, inputs, options, result.trajectory);
  simulations::settings asked = simulations::settings_of(options);
  asked.mistake_in_inputs = inputs.mistake().view();
  asked.bytes_of_sample += sizeof(double) * static_cast<std::size_t>(moved.states() + known->inputs);
  asked.is_left_out = x.is_left_out;
  static_cast<simulation_end&>(result) = simulations::run<by>(moved, result.state.data(), span, asked);
  return result;
}

/// The same for the system built so far.
template <integrator by = integrator::adams, std::derived_from<runtime::builder> Builder>
simulation<model> simulate(const Builder& built, const given_state<model>& x,
                           const given_parameters<model>& p, time_span span,
                           const simulation_options<model>& options = {}) {
  return simulate<by>(derive(built), x, p, span, options);
}

/// Returns the event in which an expression of a model crosses zero: `when(m, dot(x) - v, "slips")`.
inline event<model> when(model m, symbolic::expression passes_zero, std::string name,
                         crossing direction = crossing::either, event_handler<model> handler = {}) {
  if (!passes_zero.is_given() || !passes_zero.belongs_to(m.graph()))
    return {std::move(name), {}, direction, std::move(handler)};
  symbolic::matrix one(m.graph(), 1, 1);
  one(0, 0) = m.in_motion(passes_zero);
  return {std::move(name),
          [f = m.function(one)](double t, const state<model>& x, const parameter_values<model>& p,
                                const input_values<model>& r) mutable { return f(t, x, p, r)(0, 0); },
          direction, std::move(handler)};
}

} // namespace kanexpr
