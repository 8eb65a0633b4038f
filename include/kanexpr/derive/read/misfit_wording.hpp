#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/describe/misfit.hpp>

namespace kanexpr::deriving {

/// The word of an entity that it cannot have, or nothing.
constexpr mechanics::sentence misfit_of(describe::misfit found, std::string_view called) {
  using describe::misfit;
  using mechanics::sentence;
  const auto two_natures = [&](std::string_view both) {
    return sentence({called, " is described as ", both, "; give each a name of its own"});
  };
  switch (found) {
  case misfit::none: break;
  case misfit::hidden:
    return sentence({called, " hides what it is derived from, as a class does; write struct"});
  case misfit::name_of_another:
    return sentence({"another frame than ", called, " calls itself ", called,
                     "; the first argument of what a frame is derived from must be the frame"});
  case misfit::frame_and_point: return two_natures("a frame and as a point");
  case misfit::frame_and_body: return two_natures("a frame and as a body");
  case misfit::point_and_body: return two_natures("a point and as a body");
  case misfit::entity_and_system: return two_natures("a part of a system and as a whole one");
  case misfit::entity_and_load:
    return sentence({"a load stands beside ", called, "; write it in loads<...> of the system"});
  case misfit::two_orientations: return sentence({"frame ", called, " is given two orientations"});
  case misfit::two_places: return sentence({"point ", called, " is given two places"});
  case misfit::two_joints: return sentence({called, " is two joints; give each a name of its own"});
  case misfit::motion_beside_joint:
    return sentence({"a motion stands beside joint ", called, ", which moves as a joint of its kind does"});
  case misfit::two_bodies: return sentence({"body ", called, " is described twice"});
  case misfit::two_loads: return sentence({called, " is two loads; give each a name of its own"});
  case misfit::two_angular_velocities:
    return sentence({"frame ", called, " is given two angular velocities"});
  case misfit::two_velocities: return sentence({"point ", called, " is given two velocities"});
  case misfit::two_fixings: return sentence({"point ", called, " is fixed in two frames"});
  case misfit::angular_velocity_of_no_frame:
    return sentence({"angular_velocity<...> stands beside ", called, ", which is not a frame"});
  case misfit::velocity_of_no_point:
    return sentence({"velocity<...> stands beside ", called, ", which is not a point"});
  case misfit::fixing_of_no_point:
    return sentence({"fixed_in<...> stands beside ", called, ", which is not a point"});
  case misfit::inertia_beside:
    return sentence({"an inertia stands beside ", called, "; it belongs in rigid_body<...>"});
  case misfit::word_beside:
    return sentence({"a word of the system stands beside ", called, "; write it among those of the system"});
  }
  return {};
}

} // namespace kanexpr::deriving
