#pragma once

#include <kanexpr/compiled/state.hpp>
#include <kanexpr/simulate/simulation_options.hpp>

namespace kanexpr {

/// With what a run begins: what the study tells of it by name, which a function of what the run is given may
/// change. What nothing was told of is not a number.
template <class System>
struct run_setup {
  state<System> x;
  parameter_values<System> p;
  input_values<System> r; ///< where they are constants
};

/// The same of a simulation, with its options.
template <class System>
struct simulation_setup : run_setup<System> {
  simulation_options<System> options;
};

} // namespace kanexpr
