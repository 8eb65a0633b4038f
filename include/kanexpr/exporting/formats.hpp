#pragma once

#include <kanexpr/exporting/c/write_c.hpp>
#include <kanexpr/exporting/casadi/write_casadi.hpp>
#include <kanexpr/exporting/fmi/write_fmu.hpp>
#include <kanexpr/exporting/format.hpp>

#include <string_view>

namespace kanexpr::exporting {

/// The formats of the command kanexpr-export.
inline constexpr export_format formats[]{
    {.name = "c", .has_functions = true, .has_float = true, .has_callers = true, .write = &detail::write_c},
    {.name = "casadi", .write = &detail::write_casadi},
    {.name = "fmi", .has_functions = true, .has_simulation = true, .write = &detail::write_fmi},
};

/// Returns null if there is no format of this name.
constexpr const export_format* find_format(std::string_view name) {
  for (const export_format& each : formats)
    if (each.name == name) return &each;
  return nullptr;
}

} // namespace kanexpr::exporting
