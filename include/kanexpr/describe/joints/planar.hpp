#pragma once

#include <kanexpr/describe/joints/freed.hpp>

#include <string_view>

namespace kanexpr {

namespace describe {

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

/// The child moves by q1 along the first axis and by q2 along the second, and rotates by q3 about the normal
/// of their plane, in the direction from the first to the second: `planar<Puck, Table, axis<own::x,
/// own::y>>`. The second axis is made perpendicular to the first.
template <class Self, class Parent, class... Words>
struct planar : describe::joint<Self, Parent, describe::planar_joint, Words...> {};

} // namespace kanexpr
