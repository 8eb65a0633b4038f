#pragma once

#include <kanexpr/batch/moving_batch.hpp>
#include <kanexpr/compiled/instance.hpp>
#include <kanexpr/ensemble/kept.hpp>
#include <kanexpr/ensemble/run_setup.hpp>
#include <kanexpr/ensemble/run_values.hpp>
#include <kanexpr/ensemble/runs.hpp>
#include <kanexpr/ensemble/study_columns.hpp>

#include <functional>
#include <string>
#include <type_traits>
#include <vector>

namespace kanexpr {

/// A number that a study in steps keeps of each run: what an expression is where it ends, or the greatest or
/// least that it is where it is looked at.
template <class System, class Number = double>
struct kept_in_steps {
  using side_by_side = batch<batches::widest<Number>, Number>;

  column_label what;
  ensembles::in_time when = ensembles::in_time::at_end;
  std::function<typename side_by_side::number(double t, const typename side_by_side::template state<System>&,
                                              const typename side_by_side::template parameters<System>&,
                                              const typename side_by_side::template inputs<System>&)>
      of;
  std::string text{};   ///< by which a study is known again, beside the name
  std::string symbol{}; ///< whose unit it has if it was told none; empty: of none
};

/// A set of motions of one system in steps of a fixed length, and what is kept of each. In single precision,
/// `study_in_steps<Step, float>`, twice as many go side by side.
template <class Step, class Number = double>
struct study_in_steps {
  using System = typename compiled::stated<std::remove_cv_t<decltype(Step::eom::udot)>>::System;

  kanexpr::runs runs = {};                  ///< what differs
  std::vector<named_value> state = {};      ///< what does not, at the start
  std::vector<named_value> parameters = {}; ///< and of the parameters
  std::vector<named_value> inputs = {};     ///< and of inputs, where they are constants
  double step = 0;                          ///< in seconds, as the unit of time of the model is
  int steps = 0;
  double start = 0; ///< the time at which they begin
  /// Whether what is given for dependent coordinates and speeds is where the search for them starts. Else a
  /// run fails where the constraints contradict it.
  bool guesses_dependent = false;

  /// Changes a run by what it is given, as parameters that go together. Each run has a copy of it.
  std::function<void(const run_values&, run_setup<System>&)> for_each_run = {};

  std::vector<kept_in_steps<System, Number>> keep = {};
  int look_every = 1;             ///< after so many steps extremes are looked for, and samples are taken
  bool keep_end_state = false;    ///< all coordinates and speeds, as q1_end, where the run ends
  bool keep_trajectories = false; ///< all samples of all runs
  std::vector<unit_of> units = {};
  std::string name = {}; ///< in files; empty: that of the system
};

} // namespace kanexpr
