#pragma once

#include <kanexpr/describe/joints/joint.hpp>

/// The motion that the child would have if the joint did not constrain it, in terms of auxiliary speeds. A
/// kind of joint declares the part of this motion that it constrains, `bound_spin<Joint>` and
/// `bound_drift<Joint>`, unless it constrains all of it. Along the unconstrained directions, the child moves
/// with the joint's own speeds, as does everything else that the model expresses in terms of them.
namespace kanexpr::describe {

/// Six auxiliary speeds, along and about the axes of the child.
template <class Joint>
struct release_speeds {
  static constexpr speed<joint_name<"f1", Joint>> f1{};
  static constexpr speed<joint_name<"f2", Joint>> f2{};
  static constexpr speed<joint_name<"f3", Joint>> f3{};
  static constexpr speed<joint_name<"t1", Joint>> t1{};
  static constexpr speed<joint_name<"t2", Joint>> t2{};
  static constexpr speed<joint_name<"t3", Joint>> t3{};
};

/// The angular velocity of the child in its home due to these speeds.
template <class Joint>
inline constexpr auto freed_spin = release_speeds<Joint>::t1 * basis(&frame_of<Joint>, 0) +
                                   release_speeds<Joint>::t2 * basis(&frame_of<Joint>, 1) +
                                   release_speeds<Joint>::t3 * basis(&frame_of<Joint>, 2);
/// The velocity of the joint's point in the parent due to these speeds.
template <class Joint>
inline constexpr auto freed_drift = release_speeds<Joint>::f1 * basis(&frame_of<Joint>, 0) +
                                    release_speeds<Joint>::f2 * basis(&frame_of<Joint>, 1) +
                                    release_speeds<Joint>::f3 * basis(&frame_of<Joint>, 2);

/// Return the component of a vector along a unit vector, and the remainder.
constexpr auto part_along(const auto& given, const auto& axis) { return dot(given, axis) * axis; }
constexpr auto across(const auto& given, const auto& axis) { return given - part_along(given, axis); }

} // namespace kanexpr::describe
