#pragma once

#include <kanexpr/base/name.hpp>
#include <kanexpr/units/unit.hpp>
#include <kanexpr/units/unit_text.hpp>

#include <optional>

namespace kanexpr::units {

/// The unit of a quantity, or nothing if a model does not determine it. It is used like a
/// `std::optional<unit>`, which would cost every file that includes kanexpr four hundred templates.
class possible_unit {
public:
  constexpr possible_unit() = default;
  constexpr possible_unit(std::nullopt_t) {}
  constexpr possible_unit(const unit& u) : unit_(u), is_known_(true) {}

  constexpr bool has_value() const { return is_known_; }
  constexpr explicit operator bool() const { return is_known_; }
  /// The unit. Requires `has_value`.
  constexpr const unit& operator*() const { return unit_; }
  constexpr const unit* operator->() const { return &unit_; }

  constexpr bool operator==(const possible_unit&) const = default;

private:
  unit unit_{};
  bool is_known_ = false;
};

/// Returns a unit as text, or `not determined`.
constexpr base::name text_of(const possible_unit& u, spelling how = spelling::printed) {
  if (!u.has_value()) return "not determined";
  return text_of(*u, how);
}

} // namespace kanexpr::units
