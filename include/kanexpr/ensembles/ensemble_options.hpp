#pragma once

#include <kanexpr/base/file_path.hpp>
#include <kanexpr/ensembles/reduction.hpp>
#include <kanexpr/ensembles/results_file.hpp>

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

namespace kanexpr {

/// How a study is executed, and where its results go: `study.run({.progress = progress_bar()})`.
struct ensemble_options {
  unsigned threads = 0; ///< 0: one per core

  bool hold = true; ///< keeps all rows in memory; false: only reductions and files receive them
  std::vector<reduction> reduce = {};                    ///< updated after each run
  std::vector<std::shared_ptr<results_file>> files = {}; ///< written while the study runs

  /// A file, updated periodically, from which an interrupted study resumes: in any program that runs the same
  /// study, on any number of threads or ranks. It is removed when the study is complete.
  std::optional<file_path> checkpoint = {};
  double checkpoint_every = 60; ///< seconds

  /// Called as runs finish, with three arguments: the number of finished runs, 0, and the number of planned
  /// runs.
  std::function<void(double done, double from, double to)> progress = {};
  /// Stops the study: runs that have started are completed, and their results are kept.
  std::stop_token stop = {};
};

} // namespace kanexpr
