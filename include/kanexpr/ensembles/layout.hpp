#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace kanexpr {

/// The name of a column, and the unit of its numbers, empty if unknown.
struct column_label {
  std::string name;
  std::string unit{};
  bool operator==(const column_label&) const = default;
  static void fields(auto& self, auto& archive) { archive(self.name, self.unit); }
};

/// A value that is the same in all runs.
struct constant_of_runs {
  column_label what;
  double value;
  bool operator==(const constant_of_runs&) const = default;
  static void fields(auto& self, auto& archive) { archive(self.what, self.value); }
};

/// The quantities that a study keeps of each run.
struct study_layout {
  std::string study{};                       ///< its name
  std::size_t runs = 0;                      ///< their number
  std::size_t varied = 0;                    ///< the number of columns with varied values
  std::vector<constant_of_runs> constants{}; ///< states, parameters and inputs that do not vary
  std::vector<column_label> columns{};       ///< of the table of runs, which has a row per run
  std::vector<column_label> state{};         ///< of a failed run, at its end
  std::vector<column_label> samples{};       ///< of the trajectories, time first; empty: none are kept
  std::vector<std::string> events{};         ///< whose times are kept
  bool operator==(const study_layout&) const = default;
};

} // namespace kanexpr
