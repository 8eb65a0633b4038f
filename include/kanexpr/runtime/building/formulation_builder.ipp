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

} // namespace kanexpr::runtime
