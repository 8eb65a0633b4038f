#pragma once

#include <kanexpr/base/crossing.hpp>
#include <kanexpr/base/statistics.hpp>
#include <kanexpr/compiled/named_values.hpp>
#include <kanexpr/simulations/time_span.hpp>

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kanexpr {

/// An event that occurred.
struct occurrence {
  double t;
  std::string name;
};

namespace simulations {

/// The part of an event that does not depend on the system.
struct watched_event {
  const std::string& name;
  int direction = 0;
  bool has_value = true, has_handler = false;
};

/// The options of a simulation that do not depend on the system; see `simulation_options`.
struct settings {
  double relative_tolerance;
  std::optional<double> absolute_tolerance;
  const std::vector<named_value>& absolute_tolerances;
  double output_every;
  const std::vector<double>& output_times;
  bool dense, keep, shows_samples;
  double first_step, least_step, greatest_step;
  long most_steps;
  bool analytic_jacobian;
  std::vector<watched_event> events;
  const std::function<void(double t, time_span)>& progress;
  std::string_view mistake_in_inputs;
  bool inputs_depend_on_state, inputs_are_constant;
  std::size_t bytes_of_sample;
  bool guesses_dependent;
  std::vector<bool> is_left_out{}; ///< for each entry of the state; empty if all are given
};

/// The outcome of a simulation, apart from its samples.
struct run_outcome {
  double time = 0;
  std::vector<double> state{};
  std::vector<occurrence> events{};
  integration_statistics statistics{};
  bool stopped_by_event = false;
  std::string failure{};
};

} // namespace simulations

} // namespace kanexpr
