#pragma once

#include <kanexpr/compiled/state.hpp>
#include <kanexpr/simulations/simulation.hpp>

namespace kanexpr {

/// The initial values of a run, which `study::for_each_run` may change. Unset values are NaN.
template <class System>
struct run_setup {
  state<System> x;
  parameter_values<System> p;
  input_values<System> r; ///< used if they are constant
};

/// The setup of a simulation, with its options.
template <class System>
struct simulation_setup : run_setup<System> {
  simulation_options<System> options;
};

/// Steps of a fixed length, and their number.
struct step_span {
  double step = 0; ///< in seconds, or the time unit of the model
  int steps = 0;
  double start = 0; ///< the initial time
};

struct step_options {
  /// Takes the values of dependent coordinates and speeds as guesses. By default a run fails if the
  /// constraints contradict them.
  bool guesses_dependent = false;
  int look_every = 1; ///< the number of steps after which extremes are updated and samples taken
};

} // namespace kanexpr
