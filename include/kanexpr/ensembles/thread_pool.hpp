#pragma once

#include <kanexpr/ensembles/compiled_ensembles.hpp>
#include <kanexpr/ensembles/executor.hpp>

namespace kanexpr::ensembles {

/// Performs studies on `ensemble_options::threads` threads of this process.
class thread_pool final : public executor {
public:
  KANEXPR_ENSEMBLES ensemble_results run(const study_interface& study, const std::string& identity,
                                         const ensemble_options& options) override;
};

} // namespace kanexpr::ensembles

#ifndef KANEXPR_COMPILED_ENSEMBLES
#include <kanexpr/ensembles/thread_pool.ipp>

#include <string>
#endif
