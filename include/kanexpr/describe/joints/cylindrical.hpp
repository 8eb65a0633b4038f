#pragma once

#include <kanexpr/describe/joints/freed.hpp>

#include <string_view>

namespace kanexpr {

namespace describe {

struct cylindrical_joint {
  using symbols = joint_symbols<names<"q1", "q2">, names<"u1", "u2">>;
  static constexpr std::string_view form =
      "cylindrical<Self, Parent, axis<vector>, by<angle, displacement, their two speeds>>";
  static constexpr std::size_t least_axes = 1, most_axes = 1;
  static constexpr bool moves = true;

  template <class Joint>
  static constexpr void turn(frame_record& r) {
    turn_about(r, phrase_of<Joint::template q<0>, Joint>, phrase_of<Joint::template axis_at_home<0>, Joint>);
  }
  template <class Joint>
  static constexpr void move(point_record& r) {
    r.offset = phrase_of<Joint::template q<1> * Joint::template axis_at_home<0>, Joint>;
  }

  template <class Joint>
  static constexpr auto spin = Joint::template u<0> * Joint::template axis_at_home<0>;
  template <class Joint>
  static constexpr auto bound_spin = across(freed_spin<Joint>, Joint::template axis_of_child<0>);

  template <class Joint>
  static constexpr auto drift = Joint::template u<1> * Joint::template axis_at_home<0>;
  template <class Joint>
  static constexpr auto bound_drift = across(freed_drift<Joint>, Joint::template axis_of_child<0>);
};

} // namespace describe

/// The child rotates about an axis by q1 and slides along it by q2, independently.
template <class Self, class Parent, class... Words>
struct cylindrical : describe::joint<Self, Parent, describe::cylindrical_joint, Words...> {};

} // namespace kanexpr
