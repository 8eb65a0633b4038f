#pragma once

#include <kanexpr/base/version.hpp>
#include <kanexpr/lower/statements.hpp>
#include <kanexpr/symbolic/cost.hpp>
#include <kanexpr/units/unit.hpp>
#include <kanexpr/units/unit_text.hpp>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

/// A system as the backends see it: names and straight-line code, independent of how it was derived.
namespace kanexpr::exporting {

/// The name and version of the program that writes a file: "kanexpr 1.2.3".
inline std::string generator() {
  return "kanexpr " + std::to_string(KANEXPR_VERSION_MAJOR) + '.' + std::to_string(KANEXPR_VERSION_MINOR) +
         '.' + std::to_string(KANEXPR_VERSION_PATCH);
}

/// A unit, written in ASCII as in FMI: kg.m2/s2. Empty if the model does not determine it.
struct exported_unit {
  std::string text{};
  units::unit unit{};

  bool is_known() const { return !text.empty(); }
  bool operator==(const exported_unit&) const = default;
};

inline exported_unit written_unit(const units::unit& u) {
  return {std::string(units::text_of(u, units::spelling::plain).view()), u};
}

/// One result of a function. Its entries are stored row by row, starting at entry `first` of the function; a
/// sparse result stores its structurally nonzero entries column by column.
struct exported_result {
  std::string name{};
  int rows = 0;
  int columns = 0;
  int first = 0;
  std::vector<std::string> row_symbols{}; ///< the symbols to which the rows belong, if any
  bool is_sparse = false;
  std::vector<std::pair<int, int>> places{}; ///< column and row of each entry, if sparse
  std::vector<exported_unit> units{};        ///< of the entries, row by row; empty if none is known

  int entries() const { return is_sparse ? static_cast<int>(places.size()) : rows * columns; }
};

/// A check for a singularity. The pairs of measure and scale follow all results; see lower/scalar_math.hpp.
struct exported_check {
  std::string cause{};
  bool is_finiteness_check = false;
  bool is_order_check = false;  ///< fails unless the measure exceeds the scale
  bool watches_results = false; ///< fails unless all results are finite; the last check, without a measure
};

/// A function: its results, checks and code.
struct exported_function {
  std::string name{};
  std::vector<exported_result> results{};
  std::vector<exported_check> checks{};
  lower::statements code{};
  symbolic::cost cost{};
  bool takes_rates = false;     ///< takes the rates of the speeds as an argument
  bool takes_all_rates = false; ///< takes the rates of the state as an argument
  bool takes_step = false;      ///< takes the step length as an argument, stored as the time at position 1
  int weights = 0; ///< number of weights, or of entries of the direction, that its derivatives take

  /// The distinct causes of the checks; each has one bit of the status.
  std::vector<std::string> causes() const {
    std::vector<std::string> all;
    for (const exported_check& each : checks)
      if (std::find(all.begin(), all.end(), each.cause) == all.end()) all.push_back(each.cause);
    return all;
  }

  int entries() const { return results.empty() ? 0 : results.back().first + results.back().entries(); }
};

/// A system to be exported. The state consists of the coordinates followed by the speeds.
struct exported_system {
  std::string name{};
  std::vector<std::string> coordinates{}, speeds{}, parameters{}, inputs{};
  std::vector<exported_unit> units_of_states{}, units_of_parameters{},
      units_of_inputs{};     ///< in the same order
  bool states_units = false; ///< whether the model states the unit of any symbol
  std::vector<exported_function> functions{};

  /// Returns null if there is no function of this name.
  const exported_function* function(const std::string& called) const {
    const auto found = std::find_if(functions.begin(), functions.end(),
                                    [&](const exported_function& f) { return f.name == called; });
    return found != functions.end() ? &*found : nullptr;
  }

  std::vector<std::string> states() const {
    std::vector<std::string> all = coordinates;
    all.insert(all.end(), speeds.begin(), speeds.end());
    return all;
  }
};

} // namespace kanexpr::exporting
