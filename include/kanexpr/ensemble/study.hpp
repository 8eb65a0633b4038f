#pragma once

#include <kanexpr/ensemble/kept.hpp>
#include <kanexpr/ensemble/run_setup.hpp>
#include <kanexpr/ensemble/run_values.hpp>
#include <kanexpr/ensemble/runs.hpp>
#include <kanexpr/ensemble/study_columns.hpp>
#include <kanexpr/simulate/simulation_options.hpp>

#include <functional>
#include <string>
#include <vector>

namespace kanexpr {

/// A set of simulations of one system, and what is kept of each.
template <class System>
struct study {
  kanexpr::runs runs = {};                  ///< what differs
  std::vector<named_value> state = {};      ///< what does not, at the start
  std::vector<named_value> parameters = {}; ///< and of the parameters
  std::vector<named_value> inputs = {};     ///< and of inputs, where they are constants
  time_span span = {};
  simulation_options<System> simulation = {}; ///< of all runs; its functions are called by many threads

  /// Changes a run by what it is given, as for a push, another controller, or parameters that go together.
  /// Each run has a copy of it.
  std::function<void(const run_values&, simulation_setup<System>&)> for_each_run = {};

  std::vector<kept<System>> keep = {};
  bool keep_end_state = false;    ///< all coordinates and speeds, as q1_end, where the run ends
  bool keep_trajectories = false; ///< all samples of all runs
  bool keep_events = false;       ///< which happened when
  std::vector<unit_of> units = {};
  std::string name = {}; ///< in files; empty: that of the system
};

} // namespace kanexpr
