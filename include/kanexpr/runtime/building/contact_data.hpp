#pragma once

#include <kanexpr/mechanics/loads/contact.hpp>
#include <kanexpr/mechanics/loads/friction_law.hpp>
#include <kanexpr/mechanics/model/vector.hpp>
#include <kanexpr/runtime/building/number_or_expression.hpp>

#include <optional>

namespace kanexpr::runtime {

/// The properties of a contact in a builder. The normal force is stiffness·δ^exponent·(1 + c δ̇) at the
/// penetration δ, smoothed over `width`; the damping c is given, or follows from a coefficient of
/// restitution.
struct contact_data {
  struct restitution_at_speed {
    double coefficient = 1; ///< in (0, 1]
    number_or_expression approach_speed;
  };

  number_or_expression stiffness;
  double exponent = 1;
  number_or_expression width;
  std::optional<restitution_at_speed> restitution{};
  std::optional<number_or_expression> damping{};
  /// Without a slip speed, Coulomb friction uses 1/100 of the approach speed of the restitution.
  mechanics::friction_law friction{};
  mechanics::rotation_resistance rolling{}, spinning{};
  /// A direction along which the friction is multiplied by `ratio`, as `directional_friction<…>`.
  struct different_friction {
    mechanics::vector direction{};
    number_or_expression ratio;
  };
  std::optional<different_friction> directional{};
};

} // namespace kanexpr::runtime
