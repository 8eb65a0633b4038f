#pragma once

#include <kanexpr/ensemble/compiled_ensembles.hpp>
#include <kanexpr/ensemble/crew.hpp>

namespace kanexpr::ensembles {

/// Threads of this process.
class on_threads final : public crew {
public:
  KANEXPR_ENSEMBLES ensemble_results run(const job& study, const std::string& known_by,
                                         const ensemble_options& options) override;
};

} // namespace kanexpr::ensembles

#ifndef KANEXPR_COMPILED_ENSEMBLES
#include <kanexpr/ensemble/engine/on_threads.hpp>
#endif
