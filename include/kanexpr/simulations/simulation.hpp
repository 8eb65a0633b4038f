#pragma once

#include <kanexpr/simulations/events/event.hpp>
#include <kanexpr/simulations/inputs/input_source.hpp>
#include <kanexpr/simulations/settings.hpp>
#include <kanexpr/simulations/trajectory/trajectory.hpp>

#include <functional>
#include <optional>
#include <vector>

namespace kanexpr {

/// Options of a simulation: `simulate<System>(x, p, {0, 10}, {.output_every = 0.01})`.
template <class System>
struct simulation_options {
  input_source<System> inputs = {};
  /// Whether values given for dependent coordinates and speeds are only guesses for the solver. Otherwise a
  /// value that contradicts the constraints ends the simulation.
  bool guesses_dependent = false;

  double relative_tolerance = 1e-8; ///< permitted relative error of each step, in each coordinate and speed
  /// Added to the relative tolerance, in the unit of each entry. The default is a hundredth of the relative
  /// tolerance times the magnitude of the entry, estimated from the beginning of the motion.
  std::optional<double> absolute_tolerance = {};
  std::vector<named_value> absolute_tolerances = {}; ///< for individual coordinates and speeds

  double output_every = 0;               ///< seconds between samples; 0: a sample at each step
  std::vector<double> output_times = {}; ///< samples only at these times, in ascending order
  bool dense = false;                    ///< keep the integrator's polynomials for `trajectory::at`
  bool keep = true;                      ///< false: samples are only passed to `each_sample`
  std::function<void(const sample<System>&)> each_sample = {};

  double first_step = 0; ///< 0: the integrator chooses
  double least_step = 0;
  double greatest_step = 0;      ///< 0: no limit
  long most_steps = 10'000'000;  ///< in total
  bool analytic_jacobian = true; ///< false: by finite differences, for comparison

  std::vector<event<System>> events = {};
  /// Called after each step with the time and the span.
  std::function<void(double t, time_span)> progress = {};
};

/// The result of a simulation: the trajectory up to its end, and the cause if it ended before the end of the
/// span.
template <class System>
struct [[nodiscard]] simulation : simulation_end {
  kanexpr::trajectory<System> trajectory{};
  kanexpr::state<System> state{}; ///< the state at the end
};

} // namespace kanexpr
