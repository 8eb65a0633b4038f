#pragma once

#include <kanexpr/describe/joints/freed.hpp>

#include <string_view>

namespace kanexpr {

namespace describe {

struct prismatic_joint {
  using symbols = joint_symbols<names<"q">, names<"u">>;
  static constexpr std::string_view form = "prismatic<Self, Parent, axis<vector>, by<coordinate, speed>>";
  static constexpr std::size_t least_axes = 1, most_axes = 1;
  static constexpr bool moves = true;
  static constexpr joint_effort effort = joint_effort::force;

  template <class Joint>
  static constexpr void turn(frame_record& r) {
    not_turned<Joint>(r);
  }
  template <class Joint>
  static constexpr void move(point_record& r) {
    r.offset = phrase_of<Joint::template q<0> * Joint::template axis_at_home<0>, Joint>;
  }

  template <class Joint>
  static constexpr auto drift = Joint::template u<0> * Joint::template axis_at_home<0>;
  template <class Joint>
  static constexpr auto bound_drift = across(freed_drift<Joint>, Joint::template axis_of_child<0>);
};

} // namespace describe

/// A slider: the child moves along an axis without rotating. `prismatic<Carriage, Ground, axis<Ground::x>>`.
template <class Self, class Parent, class... Words>
struct prismatic : describe::joint<Self, Parent, describe::prismatic_joint, Words...> {};

} // namespace kanexpr
