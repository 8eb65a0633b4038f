#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/vector.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::mechanics {

/// The ways to specify the orientation of a frame relative to its parent.
enum class orientation {
  inertial,
  about_basis, ///< rotation by `angle` about axis number `axis` of the parent
  about_axis,  ///< rotation by `angle` about `direction`, a unit vector fixed in the parent; together they
               ///< determine `to_parent`
  matrix,      ///< given by `to_parent`
};

/// The rate of an orientation parameter, `by_turning` · ω/2, where ω is the angular velocity of the frame in
/// its parent, in the axes of the frame.
struct parameter_rate {
  expression parameter{};
  components by_turning{};
};

/// A right-handed triad of basis vectors, oriented relative to a parent frame.
struct frame {
  name called{};
  int parent = none;
  orientation kind = orientation::inertial;
  int axis = 0;
  expression angle{};
  components direction{}; ///< in the parent's axes
  matrix3 to_parent{};    ///< direction cosine matrix; transforms components from the frame's axes to the
                          ///< parent's
  sequence<expression> quaternion{}; ///< e0, e1, e2, e3, if the frame is given by a quaternion, which then
                                     ///< determines `to_parent`
  sequence<parameter_rate> rates{};  ///< of the orientation parameters, such as a quaternion; if empty, the
                                     ///< rates are solved for
  int reference = none;              ///< the frame in which a declared angular velocity is measured
  vector angular_velocity{};
  bool turns_apart = false; ///< declared not to match the orientation

  constexpr bool has_declared_angular_velocity() const { return reference != none; }
  /// Declares the angular velocity in the frame `in`, which is used instead of the derived one. If `apart`,
  /// it need not match the orientation.
  constexpr void declare_angular_velocity(int in, const vector& value, bool apart) {
    reference = in;
    angular_velocity = value;
    turns_apart = apart;
  }
  /// The scalars that define the orientation: the angle, or the entries of `to_parent`.
  constexpr sequence<expression> scalars() const {
    sequence<expression> all;
    if (is_by_angle()) all.push(angle);
    for (int i = 0; i < 9 && kind == orientation::matrix; ++i) all.push(to_parent(i / 3, i % 3));
    return all;
  }
  /// Whether `angle` determines the orientation.
  constexpr bool is_by_angle() const {
    return kind == orientation::about_basis || kind == orientation::about_axis;
  }
};

} // namespace kanexpr::mechanics
