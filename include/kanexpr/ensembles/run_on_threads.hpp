#pragma once

#include <kanexpr/ensembles/compiled_ensembles.hpp>
#include <kanexpr/ensembles/ensemble_options.hpp>
#include <kanexpr/ensembles/ensemble_results.hpp>
#include <kanexpr/ensembles/study_interface.hpp>

namespace kanexpr::ensembles {

/// Performs a study on `ensemble_options::threads` threads of this process.
KANEXPR_ENSEMBLES ensemble_results run_on_threads(const study_interface& study,
                                                  const ensemble_options& options);

} // namespace kanexpr::ensembles

#ifndef KANEXPR_COMPILED_ENSEMBLES
#include <kanexpr/ensembles/run_on_threads.ipp>
#endif
