#pragma once

#include <kanexpr/ensemble/collector.hpp>
#include <kanexpr/ensemble/compiled_ensembles.hpp>
#include <kanexpr/ensemble/job.hpp>

namespace kanexpr::ensembles {

/// Does a study on threads of this process.
KANEXPR_ENSEMBLES ensemble_results run_on_threads(const job& study, const std::string& known_by,
                                                  const ensemble_options& options);

} // namespace kanexpr::ensembles

#ifndef KANEXPR_COMPILED_ENSEMBLES
#include <kanexpr/ensemble/engine/on_threads.hpp>
#endif
