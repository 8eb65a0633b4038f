#pragma once

#include <kanexpr/simulate/event.hpp>
#include <kanexpr/simulate/input_source.hpp>
#include <kanexpr/simulate/time_span.hpp>
#include <kanexpr/simulate/trajectory.hpp>

#include <functional>
#include <optional>
#include <vector>

namespace kanexpr {

/// How a system is simulated: `simulate<System>(x, p, {0, 10}, {.output_every = 0.01})`.
template <class System>
struct simulation_options {
  input_source<System> inputs = {};
  /// Whether what is given for dependent coordinates and speeds is where the search for them starts. Else it
  /// ends the simulation where the constraints contradict it.
  bool guesses_dependent = false;

  double relative_tolerance = 1e-8; ///< of the error of each step, in each coordinate and speed
  /// Beside it, in the unit of each; unless given, a hundredth of the relative one times the size that the
  /// state has as far as its first instant tells.
  std::optional<double> absolute_tolerance = {};
  std::vector<named_value> absolute_tolerances = {}; ///< of coordinates and speeds that need their own

  double output_every = 0;               ///< seconds between samples; 0: each step of the integrator is one
  std::vector<double> output_times = {}; ///< samples at these times alone, in their order
  bool dense = false;                    ///< keep the integrator's polynomials for `trajectory::at`
  bool keep = true;                      ///< false: samples are handed to `each_sample` only
  std::function<void(const sample<System>&)> each_sample = {};

  double first_step = 0; ///< 0: the integrator chooses
  double least_step = 0;
  double greatest_step = 0;      ///< 0: any
  long most_steps = 10'000'000;  ///< in all
  bool analytic_jacobian = true; ///< false: by differences, for comparison

  std::vector<event<System>> events = {};
  /// Told after each step: the time, and the span.
  std::function<void(double t, time_span)> progress = {};
};

} // namespace kanexpr
