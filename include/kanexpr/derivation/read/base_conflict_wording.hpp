#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/describe/diagnostics/conflicting_bases.hpp>

#include <string_view>

namespace kanexpr::derivation {

/// Returns the sentence about a word that an entity cannot have; empty if there is none.
constexpr base::sentence base_conflict_sentence(describe::base_conflict found, std::string_view called) {
  using base::sentence;
  using describe::base_conflict;
  const auto two_natures = [&](std::string_view both) {
    return sentence({called, " is described as ", both, "; give each its own name"});
  };
  switch (found) {
  case base_conflict::none: break;
  case base_conflict::private_base: return sentence({called, " inherits privately; declare it as a struct"});
  case base_conflict::name_of_another:
    return sentence({"a frame other than ", called, " names itself ", called,
                     "; the first template argument of a frame's base must be the frame itself"});
  case base_conflict::frame_and_point: return two_natures("a frame and as a point");
  case base_conflict::frame_and_body: return two_natures("a frame and as a body");
  case base_conflict::point_and_body: return two_natures("a point and as a body");
  case base_conflict::entity_and_system: return two_natures("part of a system and as a whole system");
  case base_conflict::entity_and_load:
    return sentence({"a load is a base class of ", called, "; list it in the system's loads<...>"});
  case base_conflict::two_orientations: return sentence({"frame ", called, " has two orientations"});
  case base_conflict::two_places: return sentence({"point ", called, " has two positions"});
  case base_conflict::two_joints: return sentence({called, " is two joints; give each its own name"});
  case base_conflict::motion_of_joint:
    return sentence({"a motion is declared for joint ", called, ", whose kind determines how it moves"});
  case base_conflict::two_bodies: return sentence({"body ", called, " is described twice"});
  case base_conflict::two_loads: return sentence({called, " is two loads; give each its own name"});
  case base_conflict::two_angular_velocities:
    return sentence({"frame ", called, " has two angular velocities"});
  case base_conflict::two_velocities: return sentence({"point ", called, " has two velocities"});
  case base_conflict::two_fixings: return sentence({"point ", called, " is fixed in two frames"});
  case base_conflict::angular_velocity_of_no_frame:
    return sentence({"angular_velocity<...> is a base class of ", called, ", which is not a frame"});
  case base_conflict::velocity_of_no_point:
    return sentence({"velocity<...> is a base class of ", called, ", which is not a point"});
  case base_conflict::fixing_of_no_point:
    return sentence({"fixed_in<...> is a base class of ", called, ", which is not a point"});
  case base_conflict::misplaced_inertia:
    return sentence({"an inertia is a base class of ", called, "; it belongs in rigid_body<...>"});
  case base_conflict::misplaced_word:
    return sentence(
        {"a word of the system is a base class of ", called, "; list it among the words of the system"});
  }
  return {};
}

} // namespace kanexpr::derivation
