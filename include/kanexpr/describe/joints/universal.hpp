#pragma once

#include <kanexpr/describe/joints/freed.hpp>

#include <string_view>

namespace kanexpr {

namespace describe {

template <class Joint>
inline constexpr frame_record cross_of_joint = [] {
  frame_record r;
  r.called = r.declared_name = joint_name<"", Joint, "cross">.view();
  r.parent = Joint::home_frame();
  turn_about(r, phrase_of<Joint::template q<0>, Joint>, phrase_of<Joint::template axis_at_home<0>, Joint>);
  return r;
}();

struct universal_joint {
  using symbols = joint_symbols<names<"q1", "q2">, names<"u1", "u2">>;
  static constexpr std::string_view form =
      "universal<Self, Parent, axis<vector in the parent, vector in the child>, by<two angles, two speeds>>";
  static constexpr std::size_t least_axes = 2, most_axes = 2;
  static constexpr bool is_second_axis_of_child = true;
  static constexpr bool moves = false;

  template <class Joint>
  static constexpr void turn(frame_record& r) {
    r.parent = &cross_of_joint<Joint>;
    turn_about(r, phrase_of<Joint::template q<1>, Joint>,
               phrase_of<Joint::template axis_in<1>(&cross_of_joint<Joint>), Joint>);
  }

  template <class Joint>
  static constexpr auto spin = Joint::template u<1> * Joint::template axis_in<1>(&cross_of_joint<Joint>);
  template <class Joint>
  static constexpr auto bound_spin =
      part_along(freed_spin<Joint>, unit_along(cross(Joint::template axis_in<0>(&cross_of_joint<Joint>),
                                                     Joint::template axis_in<1>(&cross_of_joint<Joint>))));
};

} // namespace describe

/// A universal joint, or Hooke's joint: a cross rotates in the parent by q1 about the first axis, which is
/// fixed in the parent, and the child rotates on the cross by q2 about the second axis, which is fixed in the
/// child: `universal<Shaft, Parent, axis<Parent::x, own::y>>`. The angle between the axes may be any angle
/// except zero.
template <class Self, class Parent, class... Words>
struct universal : describe::joint<Self, Parent, describe::universal_joint, Words...> {};

} // namespace kanexpr
