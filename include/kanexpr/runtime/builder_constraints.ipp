#pragma once

#include <kanexpr/derivation/read/value.hpp>
#include <kanexpr/mechanics/constraints/given_constraints.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/orientation.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>

/// The constraints of a builder.
namespace kanexpr::runtime {

KANEXPR_ENGINE void builder::configuration_constraint(expression vanishes) {
  if (inspect_.own(vanishes, "a configuration constraint"))
    system_.constraints.on_configuration.push(vanishes);
}

KANEXPR_ENGINE bool builder::may_vanish(const vector& v, const vector& direction, std::string_view whose) {
  if (!inspect_.own(v, whose) || !inspect_.own(direction, whose)) return false;
  return !direction.is_zero() || inspect_.fail({whose, " has a direction of zero length"});
}

KANEXPR_ENGINE void builder::configuration_constraint(const vanishing& v) {
  constexpr std::string_view whose = "a configuration constraint";
  if (v.directions.empty()) inspect_.fail({"zero_along of ", whose, " requires at least one direction"});
  for (const vector& direction : v.directions)
    if (may_vanish(v.value, direction, whose))
      system_.constraints.on_configuration.push(derivation::dot(m_, v.value, direction));
}

KANEXPR_ENGINE void builder::velocity_constraint(expression vanishes) {
  if (inspect_.own(vanishes, "a velocity constraint"))
    system_.constraints.on_velocities.push({vanishes, {}, {}});
}

KANEXPR_ENGINE void builder::velocity_constraint(const vector& vanishes, const vector& direction) {
  if (!may_vanish(vanishes, direction, "a velocity constraint")) return;
  const int axes = direction.parts[0].frame;
  const mechanics::components velocity = mechanics::express(m_, vanishes, axes),
                              along = mechanics::express(m_, direction, axes);
  system_.constraints.on_velocities.push({mechanics::dot(velocity, along), vanishes, direction});
}

KANEXPR_ENGINE void builder::velocity_constraint(const vanishing& v) {
  if (v.directions.empty())
    inspect_.fail({"zero_along of a velocity constraint requires at least one direction"});
  for (const vector& direction : v.directions) velocity_constraint(v.value, direction);
}

KANEXPR_ENGINE void builder::acceleration_constraint(expression vanishes) {
  if (inspect_.own(vanishes, "an acceleration constraint"))
    system_.constraints.on_accelerations.push(vanishes);
}

} // namespace kanexpr::runtime
