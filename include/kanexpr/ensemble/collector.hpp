#pragma once

#include <kanexpr/base/bytes.hpp>
#include <kanexpr/ensemble/checkpoint.hpp>
#include <kanexpr/ensemble/compiled_ensembles.hpp>
#include <kanexpr/ensemble/ensemble_options.hpp>
#include <kanexpr/ensemble/ensemble_results.hpp>
#include <kanexpr/ensemble/finished_run.hpp>

#include <chrono>
#include <string>
#include <vector>

namespace kanexpr::ensembles {

/// By what a study is known again: what it is, and the version of the library that does its runs.
KANEXPR_ENSEMBLES std::string identity_of(const study_layout& layout, const std::string& known_by);

/// Takes what the runs of a study leave, in their order, and makes of it what was asked for: a table,
/// reductions, files, and a checkpoint from time to time.
class collector {
public:
  /// `known_by` tells the study from others.
  collector(const study_layout& layout, const std::string& known_by, const ensemble_options& options);

  /// Begins anew or, where there is a checkpoint, behind what was done. False: it cannot.
  bool begin();
  std::size_t done() const { return found_.done; }
  /// False: something failed, and no more is wanted.
  bool take(std::vector<finished_run>&& runs);
  /// Ends files and checkpoint, and gives what was found.
  ensemble_results end();

private:
  outcome begin_files();
  outcome take_all(std::vector<finished_run>&& runs);
  void take_one(finished_run&& one);
  outcome note_now();
  outcome go_on_from(const std::string& noted);
  table trajectory_of(const finished_run& one) const;
  bool fail(const outcome& done);

  const study_layout& layout_;
  const std::string known_by_;
  const ensemble_options& options_;
  checkpoint_file checkpoint_{};
  ensemble_results found_{};
  std::vector<std::vector<double>> columns_{};
  std::vector<std::size_t> reduced_{}; ///< the column of each reduction
  std::vector<finished_run> held_{};   ///< with trajectories or events, without their values
  std::size_t begun_ = 0;              ///< files
  std::chrono::steady_clock::time_point noted_{};
};

} // namespace kanexpr::ensembles

#ifndef KANEXPR_COMPILED_ENSEMBLES
#include <kanexpr/ensemble/engine/collector.hpp>
#endif
