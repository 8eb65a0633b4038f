#pragma once

#include <kanexpr/mechanics/model/vector.hpp>

namespace kanexpr::mechanics {

/// How a frame is oriented relative to its parent.
enum class orientation {
  inertial,
  about_basis, ///< turned by `angle` about the parent's axis number `axis`
  about_axis, ///< turned by `angle` about `direction`, a unit vector fixed in the parent; `to_parent` follows
  matrix,     ///< `to_parent` given
};

/// A right-handed triad of basis vectors, oriented relative to another.
struct frame {
  name called{};
  int parent = none;
  orientation kind = orientation::inertial;
  int axis = 0;
  expression angle{};
  components direction{}; ///< in the parent's axes
  matrix3 to_parent{};    ///< direction cosine matrix: v in the parent's axes = to_parent · v in the frame's
  sequence<expression> quaternion{}; ///< e0, e1, e2, e3, where the frame was given so; `to_parent` follows
  int reference = none;              ///< the frame that a declared angular velocity is measured in
  vector angular_velocity{};
  bool turns_apart = false; ///< from its orientation, on purpose

  constexpr bool turns_by_declaration() const { return reference != none; }
};

} // namespace kanexpr::mechanics
