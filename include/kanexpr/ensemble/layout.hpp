#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace kanexpr {

/// What a column of a table holds: its name, and the unit of its numbers, empty where none was told.
struct column_label {
  std::string name;
  std::string unit{};
  bool operator==(const column_label&) const = default;
};

/// A number that is the same in all runs.
struct constant_of_runs {
  column_label what;
  double value;
  bool operator==(const constant_of_runs&) const = default;
};

/// What a study keeps of each of its runs.
struct study_layout {
  std::string study{};                       ///< its name
  std::size_t runs = 0;                      ///< how many
  std::size_t varied = 0;                    ///< how many columns, the first, say what the run was given
  std::vector<constant_of_runs> constants{}; ///< states, parameters and inputs that do not differ
  std::vector<column_label> columns{};       ///< of the table of runs, which has a row of each
  std::vector<column_label> state{};         ///< of a run that failed, where it ended
  std::vector<column_label> samples{};       ///< of the trajectories, the time first; empty: none are kept
  std::vector<std::string> events{};         ///< those whose times are kept
  bool operator==(const study_layout&) const = default;
};

} // namespace kanexpr
