#pragma once

#include <kanexpr/ensemble/reduction.hpp>
#include <kanexpr/ensemble/results_file.hpp>
#include <kanexpr/simulate/file_path.hpp>

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

namespace kanexpr {

/// How a study is run and what becomes of its results: `study.run({.progress = progress_bar()})`.
struct ensemble_options {
  unsigned threads = 0; ///< 0: as many as the machine has cores

  bool hold = true;                   ///< false: rows go to files and reductions alone, none stay in memory
  std::vector<reduction> reduce = {}; ///< formed as the runs come
  std::vector<std::shared_ptr<results_file>> files = {}; ///< written as the runs come

  /// Where the study is noted from time to time, so that it can go on there if it is interrupted: by any
  /// program that has the same study, on any number of threads or processes. The file is gone when the study
  /// is complete.
  std::optional<file_path> checkpoint = {};
  double checkpoint_every = 60; ///< seconds

  /// Told after runs are done: how many, and from 0 to how many.
  std::function<void(double done, double from, double to)> progress = {};
  /// Asks the study to end: runs that have begun are completed, and all that was done is kept.
  std::stop_token stop = {};
};

} // namespace kanexpr
