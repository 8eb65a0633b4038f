#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/describe/misfit.hpp>

namespace kanexpr::deriving {

/// Returns the sentence about a word that an entity cannot have; empty if there is none.
constexpr mechanics::sentence misfit_of(describe::misfit found, std::string_view called) {
  using describe::misfit;
  using mechanics::sentence;
  const auto two_natures = [&](std::string_view both) {
    return sentence({called, " is described as ", both, "; give each its own name"});
  };
  switch (found) {
  case misfit::none: break;
  case misfit::hidden: return sentence({called, " inherits privately; declare it as a struct"});
  case misfit::name_of_another:
    return sentence({"a frame other than ", called, " names itself ", called,
                     "; the first template argument of a frame's base must be the frame itself"});
  case misfit::frame_and_point: return two_natures("a frame and as a point");
  case misfit::frame_and_body: return two_natures("a frame and as a body");
  case misfit::point_and_body: return two_natures("a point and as a body");
  case misfit::entity_and_system: return two_natures("part of a system and as a whole system");
  case misfit::entity_and_load:
    return sentence({"a load is a base class of ", called, "; list it in the system's loads<...>"});
  case misfit::two_orientations: return sentence({"frame ", called, " has two orientations"});
  case misfit::two_places: return sentence({"point ", called, " has two positions"});
  case misfit::two_joints: return sentence({called, " is two joints; give each its own name"});
  case misfit::motion_beside_joint:
    return sentence({"a motion is declared for joint ", called, ", whose kind determines how it moves"});
  case misfit::two_bodies: return sentence({"body ", called, " is described twice"});
  case misfit::two_loads: return sentence({called, " is two loads; give each its own name"});
  case misfit::two_angular_velocities: return sentence({"frame ", called, " has two angular velocities"});
  case misfit::two_velocities: return sentence({"point ", called, " has two velocities"});
  case misfit::two_fixings: return sentence({"point ", called, " is fixed in two frames"});
  case misfit::angular_velocity_of_no_frame:
    return sentence({"angular_velocity<...> is a base class of ", called, ", which is not a frame"});
  case misfit::velocity_of_no_point:
    return sentence({"velocity<...> is a base class of ", called, ", which is not a point"});
  case misfit::fixing_of_no_point:
    return sentence({"fixed_in<...> is a base class of ", called, ", which is not a point"});
  case misfit::inertia_beside:
    return sentence({"an inertia is a base class of ", called, "; it belongs in rigid_body<...>"});
  case misfit::word_beside:
    return sentence(
        {"a word of the system is a base class of ", called, "; list it among the words of the system"});
  }
  return {};
}

} // namespace kanexpr::deriving
