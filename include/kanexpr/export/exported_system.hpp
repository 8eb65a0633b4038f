#pragma once

#include <kanexpr/lower/statements.hpp>
#include <kanexpr/symbolic/cost.hpp>

#include <algorithm>
#include <string>
#include <vector>

/// A system as a backend writes it: names, and straight-line code. Nothing of how it was derived.
namespace kanexpr::exporting {

/// One result of a function. Its entries stand by rows among those of the function, from `first` on; of a
/// sparse one those that are not zero at all states, by columns.
struct exported_result {
  std::string name{};
  int rows = 0;
  int columns = 0;
  int first = 0;
  std::vector<std::string> of_rows{}; ///< the symbols that rows belong to, where they do
  bool is_sparse = false;
  std::vector<int> row_of{}, column_of{}; ///< each entry of a sparse one

  int entries() const { return is_sparse ? static_cast<int>(row_of.size()) : rows * columns; }
};

/// What may be singular on the way to the results. Its measure and its scale stand behind all results, by
/// pairs; see lower/regular.hpp.
struct exported_check {
  std::string cause{};
  bool of_finiteness = false;
  bool of_order = false; ///< it fails unless the measure is more than the scale
};

/// What one call computes.
struct exported_function {
  std::string name{};
  std::vector<exported_result> results{};
  std::vector<exported_check> checks{};
  lower::statements code{};
  symbolic::cost cost{};
  bool takes_rates = false;     ///< of the speeds, as an argument
  bool takes_all_rates = false; ///< of the state, as an argument
  bool takes_step = false;      ///< its length, as an argument: the time of position 1
  int weights = 0;              ///< how many numbers its derivatives are given: weights, or a direction

  /// What checks say, each once: a bit of the status.
  std::vector<std::string> causes() const {
    std::vector<std::string> all;
    for (const exported_check& each : checks)
      if (std::find(all.begin(), all.end(), each.cause) == all.end()) all.push_back(each.cause);
    return all;
  }

  int entries() const { return results.empty() ? 0 : results.back().first + results.back().entries(); }
};

/// The vectors that functions are given: states are the coordinates, then the speeds.
struct exported_system {
  std::string name{};
  std::vector<std::string> coordinates{}, speeds{}, parameters{}, inputs{};
  std::vector<exported_function> functions{};
};

} // namespace kanexpr::exporting
