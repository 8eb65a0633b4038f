#pragma once

#include <kanexpr/ensemble/ensemble_options.hpp>
#include <kanexpr/ensemble/ensemble_results.hpp>
#include <kanexpr/ensemble/job.hpp>

#include <string>

namespace kanexpr::ensembles {

/// Those who do the runs of a study together. `known_by` tells the study from others.
class crew {
public:
  crew() = default;
  crew(const crew&) = delete;
  crew& operator=(const crew&) = delete;
  virtual ~crew() = default;

  virtual ensemble_results run(const job& study, const std::string& known_by,
                               const ensemble_options& options) = 0;
};

} // namespace kanexpr::ensembles
