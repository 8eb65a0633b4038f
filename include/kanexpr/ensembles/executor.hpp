#pragma once

#include <kanexpr/ensembles/ensemble_options.hpp>
#include <kanexpr/ensembles/ensemble_results.hpp>
#include <kanexpr/ensembles/study_interface.hpp>

#include <string>

namespace kanexpr::ensembles {

/// Performs the runs of studies: the threads of this process, or the ranks of MPI.
class executor {
public:
  executor() = default;
  executor(const executor&) = delete;
  executor& operator=(const executor&) = delete;
  virtual ~executor() = default;

  /// `identity` distinguishes the study from other studies.
  virtual ensemble_results run(const study_interface& study, const std::string& identity,
                               const ensemble_options& options) = 0;
};

} // namespace kanexpr::ensembles
