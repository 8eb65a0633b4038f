#pragma once

#include <kanexpr/ensemble/ensemble_results.hpp>

namespace kanexpr {

KANEXPR_ENSEMBLES std::string ensemble_results::cause() const {
  if (!failure.empty() || done == planned) return failure;
  return "the study was ended after " + std::to_string(done) + " of " + std::to_string(planned) + " runs";
}

} // namespace kanexpr
