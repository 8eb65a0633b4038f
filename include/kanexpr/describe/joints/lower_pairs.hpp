#pragma once

#include <kanexpr/describe/joints/freed.hpp>

#include <cstddef>
#include <string_view>

/// The joints with one axis and the planar joint; the spherical and the screw joint, which are also lower
/// pairs, have separate files.
namespace kanexpr {

namespace describe {

/// A child that rotates about the joint's axis by the first coordinate.
struct turns_about_axis {
  static constexpr std::size_t least_axes = 1, most_axes = 1;

  template <class Joint>
  static constexpr void turn(frame_record& r) {
    turn_about(r, phrase_of<Joint::template q<0>, Joint>, phrase_of<Joint::template axis_at_home<0>, Joint>);
  }
  template <class Joint>
  static constexpr auto spin = Joint::template u<0> * Joint::template axis_at_home<0>;
  template <class Joint>
  static constexpr auto bound_spin = across(freed_spin<Joint>, Joint::template axis_of_child<0>);
};

/// A child that slides along the joint's axis by the coordinate with the given index.
template <std::size_t index>
struct slides_along_axis {
  template <class Joint>
  static constexpr void move(point_record& r) {
    r.offset = phrase_of<Joint::template q<index> * Joint::template axis_at_home<0>, Joint>;
  }
  template <class Joint>
  static constexpr auto drift = Joint::template u<index> * Joint::template axis_at_home<0>;
  template <class Joint>
  static constexpr auto bound_drift = across(freed_drift<Joint>, Joint::template axis_of_child<0>);
};

struct pin_joint : turns_about_axis {
  using symbols = joint_symbols<names<"q">, names<"u">>;
  static constexpr std::string_view form = "pin<Self, Parent, axis<vector>, by<coordinate, speed>>";
  static constexpr bool moves = false;
  static constexpr joint_effort effort = joint_effort::torque;
};

struct prismatic_joint : slides_along_axis<0> {
  using symbols = joint_symbols<names<"q">, names<"u">>;
  static constexpr std::string_view form = "prismatic<Self, Parent, axis<vector>, by<coordinate, speed>>";
  static constexpr std::size_t least_axes = 1, most_axes = 1;
  static constexpr bool moves = true;
  static constexpr joint_effort effort = joint_effort::force;

  template <class Joint>
  static constexpr void turn(frame_record& r) {
    not_turned<Joint>(r);
  }
};

struct cylindrical_joint : turns_about_axis, slides_along_axis<1> {
  using symbols = joint_symbols<names<"q1", "q2">, names<"u1", "u2">>;
  static constexpr std::string_view form =
      "cylindrical<Self, Parent, axis<vector>, by<angle, displacement, their two speeds>>";
  static constexpr bool moves = true;
};

struct planar_joint {
  using symbols = joint_symbols<names<"q1", "q2", "q3">, names<"u1", "u2", "u3">>;
  static constexpr std::string_view form =
      "planar<Self, Parent, axis<vector, vector>, by<two displacements, angle, their three speeds>>";
  static constexpr std::size_t least_axes = 2, most_axes = 2;
  static constexpr bool moves = true;

  template <class Joint>
  static constexpr auto first = Joint::template axis_at_home<0>;
  template <class Joint>
  static constexpr auto normal = unit_along(cross(first<Joint>, Joint::template axis_at_home<1>));
  template <class Joint>
  static constexpr auto second = cross(normal<Joint>, first<Joint>);

  template <class Joint>
  static constexpr void turn(frame_record& r) {
    turn_about(r, phrase_of<Joint::template q<2>, Joint>, phrase_of<normal<Joint>, Joint>);
  }
  template <class Joint>
  static constexpr void move(point_record& r) {
    r.offset = phrase_of<Joint::template q<0> * first<Joint> + Joint::template q<1> * second<Joint>, Joint>;
  }

  template <class Joint>
  static constexpr auto spin = Joint::template u<2> * normal<Joint>;
  template <class Joint>
  static constexpr auto drift = Joint::template u<0> * first<Joint> + Joint::template u<1> * second<Joint>;

  template <class Joint>
  static constexpr auto bound_spin = across(freed_spin<Joint>, normal<Joint>);
  template <class Joint>
  static constexpr auto bound_drift = part_along(freed_drift<Joint>, normal<Joint>);
};

} // namespace describe

/// A hinge, or revolute joint: the child rotates about an axis that is fixed in both the parent and the
/// child: `pin<Link, Parent, axis<own::z>, at<l*Parent::x>>`.
template <class Self, class Parent, class... Words>
struct pin : describe::joint<Self, Parent, describe::pin_joint, Words...> {};

/// A slider: the child moves along an axis without rotating. `prismatic<Carriage, Ground, axis<Ground::x>>`.
template <class Self, class Parent, class... Words>
struct prismatic : describe::joint<Self, Parent, describe::prismatic_joint, Words...> {};

/// The child rotates about an axis by q1 and slides along it by q2, independently.
template <class Self, class Parent, class... Words>
struct cylindrical : describe::joint<Self, Parent, describe::cylindrical_joint, Words...> {};

/// The child moves by q1 along the first axis and by q2 along the second, and rotates by q3 about the normal
/// of their plane, in the direction from the first to the second: `planar<Puck, Table, axis<own::x,
/// own::y>>`. The second axis is made perpendicular to the first.
template <class Self, class Parent, class... Words>
struct planar : describe::joint<Self, Parent, describe::planar_joint, Words...> {};

} // namespace kanexpr
