#pragma once

#include <kanexpr/runtime/building/formulation_builder.hpp>

namespace kanexpr::runtime {

KANEXPR_ENGINE void formulation_builder::written_in(frame_id frame, frame_id axes) {
  if (checks_.owns("an argument of written_in", frame, axes))
    m_.formulated.entry(place(frame)).axes = place(axes);
}

KANEXPR_ENGINE void formulation_builder::about_mass_center(frame_id frame) {
  if (checks_.owns("the argument of about_mass_center", frame))
    m_.formulated.entry(place(frame)).about_the_center = true;
}

KANEXPR_ENGINE void formulation_builder::weighted_by(const symbolic::operation_weights& weights) {
  if (weights.is_negative_for_any())
    checks_.fail({"weighted_by gives an operation a negative weight"});
  else
    m_.formulated.weights = weights;
}

} // namespace kanexpr::runtime
