#pragma once

#include <kanexpr/ensemble/on_threads.hpp>

namespace kanexpr::ensembles {

/// Has a study run by those who are there for it, unless it was told wrongly.
template <class Study>
ensemble_results run_study(const Study& study, const ensemble_options& options, crew& who) {
  if (study.mistake().empty()) return who.run(study, study.text(), options);
  ensemble_results none;
  none.planned = study.layout().runs;
  none.failure = study.mistake();
  return none;
}

} // namespace kanexpr::ensembles
