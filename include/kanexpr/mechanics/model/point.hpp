#pragma once

#include <kanexpr/mechanics/model/vector.hpp>

namespace kanexpr::mechanics {

struct point {
  name called{};
  int parent = none;    ///< none: an origin, fixed in the inertial frame
  vector offset{};      ///< relative to the parent
  int fixed_in = none;  ///< both points are fixed in this frame (two-point theorem)
  int reference = none; ///< the frame in which a declared velocity is measured
  vector velocity{};
  bool moves_apart = false; ///< declared not to match the position
  bool from_parent = false; ///< the declared velocity is relative to the parent, which is fixed in
                            ///< `reference`

  constexpr bool moves_by_declaration() const { return reference != none; }
};

} // namespace kanexpr::mechanics
