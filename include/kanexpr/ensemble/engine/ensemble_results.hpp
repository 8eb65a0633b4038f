#pragma once

#include <kanexpr/ensemble/ensemble_results.hpp>

namespace kanexpr {

KANEXPR_ENSEMBLES std::string ensemble_results::cause() const {
  if (!failure.empty()) return failure;
  if (done == planned) {
    if (*this) return {};
    const std::string first =
        failures.empty() ? std::string() : ", the first of them: " + failures.front().cause;
    return (done == 1 ? "the run failed" : "all " + std::to_string(done) + " runs failed") + first;
  }
  return "the study was ended after " + std::to_string(done) + " of " + std::to_string(planned) + " runs";
}

} // namespace kanexpr
