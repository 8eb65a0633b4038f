#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/derivation/read/value.hpp>
#include <kanexpr/mechanics/constraints/given_constraints.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/fixed.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/runtime/building/constraint_builder.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>

namespace kanexpr::runtime {

KANEXPR_ENGINE void constraint_builder::configuration_constraint(expression vanishes) {
  if (checks_.owns("a configuration constraint", vanishes))
    system_.constraints.on_configuration.push(vanishes);
}

KANEXPR_ENGINE bool constraint_builder::is_valid_direction(const vector& v, const vector& direction,
                                                           std::string_view whose) {
  return checks_.owns(whose, v, direction) &&
         (!direction.is_zero() || checks_.fail({whose, " has a direction of zero length"}));
}

KANEXPR_ENGINE void constraint_builder::configuration_constraint(const zero_components& v) {
  constexpr std::string_view whose = "a configuration constraint";
  if (v.directions.empty()) checks_.fail({"zero_along of ", whose, " requires at least one direction"});
  for (const vector& direction : v.directions)
    if (is_valid_direction(v.value, direction, whose))
      system_.constraints.on_configuration.push(derivation::dot(m_, v.value, direction));
}

KANEXPR_ENGINE void constraint_builder::velocity_constraint(expression vanishes) {
  if (checks_.owns("a velocity constraint", vanishes))
    system_.constraints.on_velocities.push({vanishes, {}, {}});
}

KANEXPR_ENGINE void constraint_builder::velocity_constraint(const vector& vanishes, const vector& direction) {
  if (!is_valid_direction(vanishes, direction, "a velocity constraint")) return;
  const int axes = direction.parts[0].frame;
  const mechanics::components velocity = mechanics::express(m_, vanishes, axes),
                              along = mechanics::express(m_, direction, axes);
  system_.constraints.on_velocities.push({mechanics::dot(velocity, along), vanishes, direction});
}

KANEXPR_ENGINE void constraint_builder::velocity_constraint(const zero_components& v) {
  if (v.directions.empty())
    checks_.fail({"zero_along of a velocity constraint requires at least one direction"});
  for (const vector& direction : v.directions) velocity_constraint(v.value, direction);
}

KANEXPR_ENGINE void constraint_builder::acceleration_constraint(expression vanishes) {
  if (checks_.owns("an acceleration constraint", vanishes))
    system_.constraints.on_accelerations.push(vanishes);
}

KANEXPR_ENGINE void constraint_builder::dependent(expression e) {
  if (!checks_.owns("the argument of dependent", e)) return;
  const int q = m_.coordinates.find(e), u = m_.speeds.find(e);
  base::sequence<int>& chosen =
      q >= 0 ? system_.constraints.dependent_coordinates : system_.constraints.dependent_speeds;
  const int at = q >= 0 ? q : u;
  if (at < 0)
    checks_.fail({"the argument of dependent is neither a coordinate nor a speed"});
  else if (chosen.contains(at))
    checks_.fail({mechanics::called(m_, e), " is declared dependent twice"});
  else
    chosen.push(at);
}

} // namespace kanexpr::runtime
