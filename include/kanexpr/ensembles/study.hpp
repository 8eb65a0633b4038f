#pragma once

#include <kanexpr/compiled/instance.hpp>
#include <kanexpr/compiled/named_values.hpp>
#include <kanexpr/compiled/state.hpp>
#include <kanexpr/ensembles/run_output.hpp>
#include <kanexpr/ensembles/runs.hpp>
#include <kanexpr/simulations/settings.hpp>
#include <kanexpr/simulations/simulation.hpp>

#include <functional>
#include <string>
#include <type_traits>
#include <vector>

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
  simulation_options<System> options = {};
};

/// Steps of a fixed length, and their number.
struct step_span {
  double step = 0; ///< in seconds, or the time unit of the model
  int steps = 0;
  double start = 0; ///< the initial time
};

/// Options of the runs of a study in steps.
struct step_options {
  /// Treats the values of dependent coordinates and speeds as guesses. By default a run fails if the
  /// constraints contradict them.
  bool guesses_dependent = false;
  int look_every = 1; ///< the number of steps after which extremes are updated and samples taken
};

/// The unit of a symbol or factor, for the columns of tables: `{q1, "rad"}`.
struct unit_of {
  varied_name what;
  std::string unit;
};

namespace ensembles {

/// The types in studies whose runs are performed by `simulate`.
template <class Simulated>
struct simulation_kind {
  using System = Simulated;
  using span = time_span;
  using options = simulation_options<System>;
  using setup = simulation_setup<System>;
  using output = run_output<System>;
};

/// The types in studies whose runs are performed by steps of a fixed length.
template <class Step, class Number>
struct step_kind {
  using System = typename compiled::results_with_status<std::remove_cv_t<decltype(Step::eom::udot)>>::System;
  using span = step_span;
  using options = step_options;
  using setup = run_setup<System>;
  using output = step_output<System, Number>;
};

} // namespace ensembles

/// A set of runs of one system, and the outputs to keep for each.
template <class Kind>
struct study_of {
  kanexpr::runs runs = {};                  ///< the values that vary from run to run
  std::vector<named_value> state = {};      ///< the constant values of the initial state
  std::vector<named_value> parameters = {}; ///< the constant values of parameters
  std::vector<named_value> inputs = {};     ///< the constant values of inputs
  typename Kind::span span = {};
  typename Kind::options simulation = {}; ///< options of all runs; several threads call their functions

  /// Changes the setup of a run that depends on the varied values in another way: for a push, a controller,
  /// or parameters that vary together. Each run uses its own copy of the function.
  std::function<void(const run_values&, typename Kind::setup&)> for_each_run = {};

  std::vector<typename Kind::output> keep = {};
  bool keep_end_state = false;     ///< the state at the end of each run, as q1_end
  bool keep_trajectories = false;  ///< all samples of all runs
  bool keep_events = false;        ///< the times of all events
  std::vector<unit_of> units = {}; ///< where they differ from those that the model states
  std::string name = {};           ///< in files; by default the name of the system
};

/// A study whose runs are performed by `simulate`.
template <class System>
using study = study_of<ensembles::simulation_kind<System>>;

/// A study whose runs are performed by steps of a fixed length: `.span = {.step = 1e-3, .steps = 500}`. In
/// single precision, `study_in_steps<Step, float>`, twice as many runs fit into a SIMD vector.
template <class Step, class Number = double>
using study_in_steps = study_of<ensembles::step_kind<Step, Number>>;

} // namespace kanexpr
