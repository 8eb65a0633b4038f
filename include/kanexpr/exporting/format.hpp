#pragma once

#include <kanexpr/base/outcome.hpp>
#include <kanexpr/compiled/named_values.hpp>
#include <kanexpr/exporting/exporter.hpp>
#include <kanexpr/exporting/text/scalar.hpp>
#include <kanexpr/runtime/staged_derivation.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kanexpr::exporting {

/// The options of the command kanexpr-export.
struct export_options {
  std::filesystem::path folder{};
  std::string name{};
  std::vector<requested_function> functions{}; ///< if empty, the default of the format
  std::vector<bound_parameter> bound{};
  precision number = precision::double_precision;
  bool with_python = false, with_cpp = false;
  std::vector<named_value> start{};
  std::optional<double> step{};
  std::optional<std::string> compiler{};
};

/// The options that a format supports, and the function that writes its files.
struct export_format {
  std::string_view name{};
  bool has_functions = false;  ///< exports the requested functions
  bool has_float = false;      ///< supports single precision
  bool has_callers = false;    ///< can write files for Python and C++
  bool has_simulation = false; ///< takes start values and a step
  outcome (*write)(runtime::staged_derivation&, const export_options&) = nullptr;
};

} // namespace kanexpr::exporting
