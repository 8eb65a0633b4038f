#pragma once

#include <kanexpr/base/crossing.hpp>
#include <kanexpr/export/exported_system.hpp>

#include <cstdint>

namespace kanexpr::exporting {

/// A scalar variable of an FMU with its place in a row of them.
struct fmu_variable {
  std::string name{};
  std::string of{}; ///< what the model calls it, where that is another name
  double start = 0;
};

/// What happens to an entry of the state at an event.
struct fmu_change {
  int event = 0;
  int place = 0; ///< in the state
};

/// An FMU as its files tell of it. Its system has functions by the names below, those alone that are needed.
struct fmu {
  static constexpr const char *rates = "rhs", *jacobian = "jacobian", *rates_by_time = "rhs_by_time",
                              *measured = "measured", *measured_derivatives = "measured_derivatives",
                              *changes = "changes", *step = "step", *correction = "to_constraints";

  exported_system system{};
  // in the order of their value references, after the time; the rates of the states behind the states
  std::vector<fmu_variable> states{}, rates_of_states{}, parameters{}, inputs{}, outputs{}, indicators{};
  std::string time = "time";          ///< by its name
  std::vector<crossing> directions{}; ///< of the events
  std::vector<bool> ends{};           ///< whether an event ends the motion
  std::vector<fmu_change> changed{};  ///< in the order of the entries of `changes`
  std::vector<bool> dependent{};      ///< of the states
  double step_length = 0;

  int count_of_states() const { return static_cast<int>(states.size()); }
  int count_of_measured() const { return static_cast<int>(outputs.size() + indicators.size()); }

  // value references
  static constexpr int first_state = 1;
  int first_rate() const { return first_state + count_of_states(); }
  int first_parameter() const { return first_rate() + count_of_states(); }
  int first_input() const { return first_parameter() + static_cast<int>(parameters.size()); }
  int first_output() const { return first_input() + static_cast<int>(inputs.size()); }
  int first_indicator() const { return first_output() + static_cast<int>(outputs.size()); }

  /// Null where it is not needed.
  const exported_function* function(const std::string& name) const {
    for (const exported_function& f : system.functions)
      if (f.name == name) return &f;
    return nullptr;
  }

  /// Whether an entry of a result vanishes at all states.
  static bool is_zero(const exported_function& f, int entry) {
    const lower::statement& s = f.code.lines[f.code.results[entry]];
    return s.is == lower::statement::kind::number && f.code.numbers[s.a] == symbolic::number{};
  }
};

/// The same for the same texts, and hardly ever for others: FNV-1a, twice.
inline std::string token_of(const std::vector<std::string>& texts) {
  std::string digits;
  for (std::uint64_t hash : {0xcbf29ce484222325ull, 0x84222325cbf29ce4ull}) {
    for (const std::string& text : texts)
      for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
    for (int i = 60; i >= 0; i -= 4) digits += "0123456789abcdef"[hash >> i & 0xfu];
  }
  return digits;
}

} // namespace kanexpr::exporting
