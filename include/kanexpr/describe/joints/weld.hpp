#pragma once

#include <kanexpr/describe/joints/joint.hpp>

#include <string_view>

namespace kanexpr {

namespace describe {

struct weld_joint {
  using symbols = joint_symbols<names<>, names<>>;
  static constexpr std::string_view form = "weld<Self, Parent>, without axes or symbols";
  static constexpr std::size_t least_axes = 0, most_axes = 0;
  static constexpr bool moves = false;

  template <class Joint>
  static constexpr void turn(frame_record& r) {
    not_turned<Joint>(r);
  }
};

} // namespace describe

/// Fixes the child in the parent: `weld<Tool, Flange, at<0.1*Flange::z>, body<…>>`.
template <class Self, class Parent, class... Words>
struct weld : describe::joint<Self, Parent, describe::weld_joint, Words...> {};

} // namespace kanexpr
