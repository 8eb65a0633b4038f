#pragma once

#include <kanexpr/describe/misfit.hpp>
#include <kanexpr/mechanics/problem.hpp>

namespace kanexpr::derivation {

/// What an entity is told that it cannot be told, or nothing.
constexpr mechanics::problem misfit_of(describe::misfit found, std::string_view called) {
  using describe::misfit;
  using mechanics::sentence;
  switch (found) {
  case misfit::none: break;
  case misfit::two_orientations: return sentence({"frame ", called, " is given two orientations"});
  case misfit::two_places: return sentence({"point ", called, " is given two places"});
  case misfit::two_bodies: return sentence({"body ", called, " is described twice"});
  case misfit::two_angular_velocities:
    return sentence({"frame ", called, " is given two angular velocities"});
  case misfit::two_velocities: return sentence({"point ", called, " is given two velocities"});
  case misfit::two_fixings: return sentence({"point ", called, " is said to be fixed in two frames"});
  case misfit::angular_velocity_of_no_frame:
    return sentence({"angular_velocity<...> stands beside ", called, ", which is no frame"});
  case misfit::velocity_of_no_point:
    return sentence({"velocity<...> stands beside ", called, ", which is no point"});
  case misfit::fixing_of_no_point:
    return sentence({"fixed_in<...> stands beside ", called, ", which is no point"});
  case misfit::inertia_beside:
    return sentence({"an inertia stands beside ", called, "; it belongs into rigid_body<...>"});
  }
  return {};
}

} // namespace kanexpr::derivation
