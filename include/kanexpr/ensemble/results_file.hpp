#pragma once

#include <kanexpr/base/outcome.hpp>
#include <kanexpr/ensemble/finished_run.hpp>
#include <kanexpr/ensemble/layout.hpp>

#include <string>

namespace kanexpr {

/// Where the results of a study go as they come: run after run, in the order of their numbers, whatever the
/// order was in which they ended. Its functions are called one at a time.
class results_file {
public:
  results_file() = default;
  results_file(const results_file&) = delete;
  results_file& operator=(const results_file&) = delete;
  virtual ~results_file() = default;

  /// The path at which it is a file; empty: at none.
  virtual std::string path() const { return {}; }
  /// Whether it can hold what a study keeps: asked of all files before the first of them begins.
  virtual outcome fits(const study_layout&) const { return {}; }
  /// Begins anew, or goes on behind a position that `flush` told: what was written behind it goes.
  virtual outcome begin(const study_layout& layout) = 0;
  virtual outcome go_on(const study_layout& layout, const std::string& position) = 0;

  virtual outcome take(const finished_run& run) = 0;
  /// Hands all that was taken to the system, so that others can read it. `position` tells how far it is.
  virtual outcome flush(std::string& position) = 0;
  /// Ends the file, whether or not all runs are in it.
  virtual outcome end() = 0;
};

} // namespace kanexpr
