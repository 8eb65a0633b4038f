#pragma once

#include <kanexpr/base/crossing.hpp>
#include <kanexpr/exporting/exported_system.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace kanexpr::exporting {

/// A scalar variable of an FMU; its position in its list determines its value reference.
struct fmu_variable {
  std::string name{};
  std::string name_in_model{}; ///< if different
  double start = 0;
  bool is_dependent = false; ///< follows from the constraints
  exported_unit unit{};
};

/// A change in an entry of the state at an event.
struct fmu_change {
  int event = 0;
  int place = 0; ///< index in the state
};

/// The contents of an FMU. Its system has functions with the names below if they are needed.
struct fmu {
  static constexpr const char *rates = "rhs", *jacobian = "jacobian", *rates_by_time = "rhs_by_time",
                              *measured = "measured", *measured_derivatives = "measured_derivatives",
                              *changes = "changes", *step = "step", *correction = "to_constraints";

  exported_system system{};
  // in the order of their value references, which start after the time; the rates follow the states
  std::vector<fmu_variable> states{}, rates_of_states{}, parameters{}, inputs{}, outputs{}, indicators{};
  std::string time = "time";          ///< name of the time variable
  std::vector<crossing> directions{}; ///< one for each event
  std::vector<bool> ends{};           ///< whether each event ends the motion
  std::vector<fmu_change> changed{};  ///< in the order of the entries of `changes`
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

  /// Whether an entry of a result is identically zero.
  static bool is_zero(const exported_function& f, int entry) {
    const lower::statement& s = f.code.lines[f.code.results[entry]];
    return s.is == lower::statement::kind::number && f.code.numbers[s.a] == symbolic::number{};
  }
};

/// 128-bit content hash: FNV-1a with two offsets.
inline std::string content_hash(const std::vector<std::string>& texts) {
  std::string digits;
  for (std::uint64_t hash : {0xcbf29ce484222325ull, 0x84222325cbf29ce4ull}) {
    for (const std::string& text : texts)
      for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
    for (int i = 60; i >= 0; i -= 4) digits += "0123456789abcdef"[hash >> i & 0xfu];
  }
  return digits;
}

} // namespace kanexpr::exporting
