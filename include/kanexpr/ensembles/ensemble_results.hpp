#pragma once

#include <kanexpr/ensembles/reduction.hpp>
#include <kanexpr/simulations/settings.hpp>
#include <kanexpr/simulations/tables/table.hpp>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace kanexpr {

/// The cause of a failed run, and the state in which it ended.
struct failed_run {
  std::size_t run;
  double time;
  std::vector<double> state; ///< coordinates and speeds where the run ended
  std::string cause;

  static void fields(auto& self, auto& archive) { archive(self.run, self.time, self.state, self.cause); }
};

/// The results of a study.
struct [[nodiscard]] ensemble_results {
  /// One row per run, in order: its number, how it ended (0 reached the end, 1 stopped by an event, 2
  /// failed), its end time, its varied values, and the outputs that the study keeps, NaN if the run failed.
  /// Empty if `ensemble_options::hold` is false.
  table runs{};
  std::vector<failed_run> failures{}; ///< at most the first thousand
  std::vector<reduction> reductions{};
  std::vector<table> trajectories{};             ///< trajectories of the runs, if the study keeps them
  std::vector<std::vector<occurrence>> events{}; ///< events of the runs, if the study keeps them

  std::size_t planned = 0; ///< the number of runs of the study
  std::size_t done = 0;    ///< the number of runs performed, including failed ones
  std::size_t failed = 0;
  std::string failure{}; ///< why the study itself could not start or continue; empty if it could

  /// True if all runs are done and at least one of them succeeded.
  explicit operator bool() const {
    return failure.empty() && done == planned && !(failed > 0 && failed == done);
  }
  /// Returns the cause of a failure, as a sentence; empty on success.
  std::string cause() const {
    if (!failure.empty() || *this) return failure;
    if (done < planned)
      return "the study was stopped after " + std::to_string(done) + " of " + std::to_string(planned) +
             " runs";
    return (done == 1 ? "the run failed" : "all " + std::to_string(done) + " runs failed") +
           (failures.empty() ? std::string() : ", the first of them: " + failures.front().cause);
  }

  /// Return the reductions of a column. A reduction that was not requested is empty; its `count()` is 0.
  const kanexpr::statistics& statistics(std::string_view column) const {
    return reduced<kanexpr::statistics>(column);
  }
  const quantile_sketch& quantiles(std::string_view column) const { return reduced<quantile_sketch>(column); }
  const kanexpr::histogram& histogram(std::string_view column) const {
    return reduced<kanexpr::histogram>(column);
  }
  const value_counts& counts(std::string_view column) const { return reduced<value_counts>(column); }

private:
  template <class Reduction>
  const Reduction& reduced(std::string_view column) const {
    static const Reduction none{};
    for (const reduction& each : reductions)
      if (const auto* found = std::get_if<Reduction>(&each.what); found && each.column == column)
        return *found;
    return none;
  }
};

} // namespace kanexpr
