#pragma once

#include <kanexpr/base/outcome.hpp>
#include <kanexpr/ensembles/study_interface.hpp>

#include <string>

namespace kanexpr {

/// A file, or another destination, that receives the results of a study in the order of the runs while the
/// study is running. Its functions are called one at a time.
class results_file {
public:
  results_file() = default;
  results_file(const results_file&) = delete;
  results_file& operator=(const results_file&) = delete;
  virtual ~results_file() = default;

  /// Succeeds if the file can hold the quantities that a study keeps; checked for all files before the first
  /// run.
  virtual outcome fits(const study_layout&) const { return {}; }
  /// Starts a new file.
  virtual outcome begin(const study_layout& layout) = 0;
  /// Resumes an existing file at a position that `flush` reported, and discards the rows after it.
  virtual outcome resume(const study_layout& layout, const std::string& position) = 0;

  virtual outcome take(const finished_run& run) = 0;
  /// Writes all results taken so far, so that other programs can read them, and reports the position.
  virtual outcome flush(std::string& position) = 0;
  /// Completes the file, which may lack some of the runs.
  virtual outcome end() = 0;
};

} // namespace kanexpr
