#pragma once

#include "timing.hpp"

#include <kanexpr/ensemble.hpp>
#include <models/double_pendulum.hpp>

#include <cstddef>
#include <cstdint>
#include <numbers>

/// A double pendulum without friction that is let go at rest with its bars above the joints: chaotic motions,
/// which differ in what they cost.
namespace pendulums {

using namespace kanexpr;
using namespace double_pendulum;

inline const std::vector<named_value> at_rest{{u1, 0}, {u2, 0}}, without_motors{{T1, 0}, {T2, 0}},
    bars{{m1, 1},       {m2, 1},       {d1, 0.5}, {d2, 0.5}, {l1, 1},
         {I1, 1 / 12.}, {I2, 1 / 12.}, {g, 9.81}, {c1, 0},   {c2, 0}};
constexpr time_span span{0, 10}; // s
constexpr double tolerance = 1e-6, step = 1e-3;

inline runs starts(std::size_t count) {
  constexpr double pi = std::numbers::pi;
  return random_runs(count, {{q1, uniform(0.1, pi - 0.1)}, {q2, uniform(-1, 1)}}, 16);
}

inline study<System> in_full(std::size_t count) {
  return {.runs = starts(count),
          .state = at_rest,
          .parameters = bars,
          .inputs = without_motors,
          .span = span,
          .simulation = {.relative_tolerance = tolerance},
          .keep = {at_end<q1>("q1_end"), at_end<q2>("q2_end")}};
}

template <class Number = double>
study_in_steps<runge_kutta_4<System>, Number> in_steps(std::size_t count) {
  return {.runs = starts(count),
          .state = at_rest,
          .parameters = bars,
          .inputs = without_motors,
          .span = {.step = step, .steps = static_cast<int>(span.to / step)},
          .simulation = {.look_every = static_cast<int>(span.to / step)},
          .keep = {at_end<q1>("q1_end"), at_end<q2>("q2_end")}};
}

/// The same numbers, whoever formed them, have the same sum.
using sum = double;

inline sum of_table(const ensemble_results& found) {
  if (!found || found.failed > 0) timing::give_up(found.cause());
  sum all = 0;
  for (double angle : found.runs["q1_end"]) all += angle;
  return all;
}

inline state<System> start_of(const runs& all, std::size_t run) {
  const run_values given(all, run);
  return {{q1, given[q1]}, {q2, given[q2]}, {u1, 0}, {u2, 0}};
}

inline sum bare_simulations(std::size_t count, std::size_t first = 0, std::size_t stride = 1) {
  const runs all = starts(count);
  const given_parameters<System> p(bars);
  const simulation_options<System> options{.inputs = given_inputs<System>(without_motors),
                                           .relative_tolerance = tolerance,
                                           .output_times = {span.to}};
  sum found = 0;
  for (std::size_t i = first; i < count; i += stride) {
    const auto ended = simulate<System>(start_of(all, i), p, span, options);
    if (!ended) timing::give_up(ended.cause());
    found += ended.state[q1];
  }
  return found;
}

} // namespace pendulums
