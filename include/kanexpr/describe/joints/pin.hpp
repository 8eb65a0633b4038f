#pragma once

#include <kanexpr/describe/joints/freed.hpp>

#include <string_view>

namespace kanexpr {

namespace describe {

struct pin_joint {
  using symbols = joint_symbols<names<"q">, names<"u">>;
  static constexpr std::string_view form = "pin<Self, Parent, axis<vector>, by<coordinate, speed>>";
  static constexpr std::size_t least_axes = 1, most_axes = 1;
  static constexpr bool moves = false;
  static constexpr joint_effort effort = joint_effort::torque;

  template <class Joint>
  static constexpr void turn(frame_record& r) {
    turn_about(r, phrase_of<Joint::template q<0>, Joint>, phrase_of<Joint::template axis_at_home<0>, Joint>);
  }

  template <class Joint>
  static constexpr auto spin = Joint::template u<0> * Joint::template axis_at_home<0>;
  template <class Joint>
  static constexpr auto bound_spin = across(freed_spin<Joint>, Joint::template axis_of_child<0>);
};

} // namespace describe

/// A hinge, or revolute joint: the child rotates about an axis that is fixed in both the parent and the
/// child: `pin<Link, Parent, axis<own::z>, at<l*Parent::x>>`.
template <class Self, class Parent, class... Words>
struct pin : describe::joint<Self, Parent, describe::pin_joint, Words...> {};

} // namespace kanexpr
