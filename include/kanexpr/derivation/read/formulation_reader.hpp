#pragma once

#include <kanexpr/derivation/read/entity_reader.hpp>
#include <kanexpr/derivation/read/reading.hpp>
#include <kanexpr/describe/formulation.hpp>
#include <kanexpr/mechanics/model/formulation.hpp>

namespace kanexpr::derivation {

/// Reads how the equations of a system are formed. Requires that its entities were read.
constexpr void read_formulation(const describe::formulation_record& from, reading& all, entity_reader& read) {
  if (!from.stranger.empty())
    return all.fail({short_name(from.stranger).view(), " is not a part of formulation<...>; it takes ",
                     "written_in<frame, axes>, about_mass_center<frame>, by_elimination, ",
                     "by_articulated_bodies, in_absolute_speeds and weighted_by<weights>"});
  if (from.weights.is_negative_for_any())
    return all.fail({"weighted_by<...> gives an operation a negative weight"});
  mechanics::formulation& into = all.into.mechanism.formulated;
  into.solved_by = from.solved_by;
  into.speeds = from.speeds;
  into.weights = from.weights;
  for (const describe::frame_formulation_record& r : from.frames) {
    if (r.frame == nullptr) continue;
    for (const frame_record* each : {r.frame, r.axes})
      if (each != nullptr && each->instead.empty() && !read.frames_read().contains(each))
        all.fail({"frame ", each->called, " in formulation<...> belongs to no part of the system"});
    if (all.mistake) return;
    mechanics::formulation_of_frame& one = into.entry(read.frame(r.frame, "formulation<...>"));
    if (r.axes != nullptr) one.axes = read.frame(r.axes, "formulation<...>");
    one.about_the_center = one.about_the_center || r.about_the_center;
  }
}

} // namespace kanexpr::derivation
