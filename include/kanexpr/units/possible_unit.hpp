#pragma once

#include <kanexpr/base/name.hpp>
#include <kanexpr/units/unit.hpp>
#include <kanexpr/units/unit_text.hpp>

#include <optional>

namespace kanexpr::units {

/// The unit of a quantity, or nothing if a model does not determine it.
using possible_unit = std::optional<unit>;

/// Returns a unit as text, or `not determined`.
constexpr base::name text_of(const possible_unit& u, spelling how = spelling::printed) {
  if (!u.has_value()) return "not determined";
  return text_of(*u, how);
}

} // namespace kanexpr::units
