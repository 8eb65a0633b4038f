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

KANEXPR_ENGINE zero_components constraint_builder::parallel(const vector& direction, frame_id frame,
                                                            int axis) {
  if (axis < 0 || axis > 2) {
    checks_.fail({"expected an axis of parallel from 0 to 2, got ", base::counted(axis).view()});
    return {};
  }
  if (!checks_.owns("the argument of parallel", frame, direction)) return {};
  return {direction, {axis_of(frame, (axis + 1) % 3), axis_of(frame, (axis + 2) % 3)}};
}

KANEXPR_ENGINE zero_components constraint_builder::same_axes(frame_id frame, frame_id other) {
  if (!checks_.owns("the argument of same_axes", frame, other)) return {};
  vector turned;
  for (int i = 0; i < 3; ++i) {
    const expression sine = derivation::dot(m_, axis_of(frame, i), axis_of(other, (i + 1) % 3));
    turned.add(sine * axis_of(other, i));
  }
  return {turned, {axis_of(other, 0), axis_of(other, 1), axis_of(other, 2)}};
}

KANEXPR_ENGINE vector constraint_builder::axis_of(frame_id frame, int index) const {
  mechanics::components unit(*m_.g);
  unit[index] = m_.one();
  vector v;
  v.add(place(frame), unit);
  return v;
}

KANEXPR_ENGINE expression constraint_builder::rod_of_length(point_id point, point_id other,
                                                            expression length) {
  if (!checks_.owns("the length of a rod", length)) return m_.zero();
  const vector between = points_.position_of(point, other);
  const expression square = derivation::dot(m_, between, between);
  return square - length * length;
}

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
