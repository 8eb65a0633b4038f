#pragma once

#include <kanexpr/base/crossing.hpp>
#include <kanexpr/base/statistics.hpp>
#include <kanexpr/compiled/named_values.hpp>

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kanexpr {

/// A time span, in seconds.
struct time_span {
  double from = 0;
  double to = 0;
};

/// The integration method of a simulation.
enum class integrator {
  /// Adams' multistep formulas of order 1 to 12 (CVODE); they need the fewest evaluations for smooth motions.
  /// The state is projected onto the constraints after each step, and the drift of the formulas is corrected.
  adams,
  /// Backward differentiation of order 1 to 5 with exact derivatives (CVODE), for stiff systems.
  bdf,
  /// Dormand & Prince's explicit Runge-Kutta pair of order 5 (ARKODE), for motions with many events and
  /// discontinuous inputs, since each step starts afresh.
  explicit_runge_kutta,
  /// Kvaerno's implicit pair of order 5 with exact derivatives (ARKODE), for stiff systems with many events.
  implicit_runge_kutta,
  /// The equations for all speeds with their multipliers, as a differential-algebraic system (IDA). No choice
  /// of dependent coordinates and speeds is involved, so a motion may pass through positions where that
  /// choice is singular. The constraints are satisfied within the tolerances. Near positions where they
  /// become dependent, `bdf` replaces this method.
  differential_algebraic,
};

/// An event that occurred.
struct occurrence {
  double t;
  std::string name;
};

/// The end of a simulation: the part of its result that does not depend on the system.
struct simulation_end {
  std::vector<occurrence> events{}; ///< in chronological order
  integration_statistics statistics{};
  double time = 0;               ///< the time at which it ended
  bool stopped_by_event = false; ///< requested by the handler of the last event
  std::string failure{};         ///< the cause of a failure, as a sentence; empty on success

  explicit operator bool() const { return failure.empty(); }
  std::string cause() const { return failure; }
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

} // namespace simulations

} // namespace kanexpr
