#pragma once

#include <kanexpr/ensemble/compiled_ensembles.hpp>
#include <kanexpr/ensemble/layout.hpp>
#include <kanexpr/ensemble/reduction.hpp>
#include <kanexpr/simulate/settings.hpp>
#include <kanexpr/simulate/table.hpp>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace kanexpr {

/// A run that failed: why, and in which state.
struct failed_run {
  std::size_t run;
  double time;
  std::vector<double> state; ///< coordinates and speeds, where it ended
  std::string cause;
};

/// What a study found.
struct [[nodiscard]] ensemble_results {
  /// A row of each run, in their order: its number, how it ended (0 reached the end, 1 stopped by an event, 2
  /// failed), when, what it was given, and what is kept of it, which is not a number where the run failed.
  /// Empty if rows were not to be held.
  table runs{};
  std::vector<failed_run> failures{}; ///< the first thousand of them
  std::vector<reduction> reductions{};
  std::vector<table> trajectories{};             ///< of each run, if they are kept
  std::vector<std::vector<occurrence>> events{}; ///< of each run, if they are kept

  std::size_t planned = 0; ///< runs
  std::size_t done = 0;    ///< the first so many, those that failed among them
  std::size_t failed = 0;
  std::string failure{}; ///< why the study itself could not begin or go on, as a sentence; empty: it could

  /// Whether all runs are done. Some of them may have failed, but not all.
  explicit operator bool() const {
    return failure.empty() && done == planned && !(failed > 0 && failed == done);
  }
  /// Why not.
  KANEXPR_ENSEMBLES std::string cause() const;

  /// What was formed of a column; without numbers if it was not asked for.
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

#ifndef KANEXPR_COMPILED_ENSEMBLES
#include <kanexpr/ensemble/engine/ensemble_results.hpp>
#endif
