#pragma once

#include <kanexpr/describe/joints/lower_pairs.hpp>

#include <string_view>
#include <type_traits>

namespace kanexpr {

namespace describe {
struct advances {};
} // namespace describe

/// The advance of a screw per radian, in meters: p/(2π) for a thread that advances by p per turn, negative
/// for a left-handed thread.
template <auto advance>
struct pitch {
  static constexpr describe::joint_word joint_word = describe::joint_word::special;
  using special = describe::advances;
  static constexpr std::string_view twice = "has two pitches";
  static constexpr std::string_view misplaced = "has pitch<...>, which belongs to a screw<...>";
  static constexpr auto value = advance;
};

namespace describe {

struct screw_joint : turns_about_axis {
  using symbols = joint_symbols<names<"q">, names<"u">>;
  static constexpr std::string_view form =
      "screw<Self, Parent, axis<vector>, pitch<advance per radian>, by<coordinate, speed>>";
  static constexpr bool moves = true;
  using special = advances;
  static constexpr std::string_view without_special = "lacks a pitch";
  static constexpr joint_effort effort = joint_effort::torque;

  template <class Joint>
  static constexpr auto pitch_of() {
    using given = typename Joint::template word<joint_word::special>;
    if constexpr (std::is_void_v<given>)
      return constant(1);
    else
      return whole_argument(given::value);
  }

  template <class Joint>
  static constexpr void move(point_record& r) {
    r.offset = phrase_of<pitch_of<Joint>() * Joint::template q<0> * Joint::template axis_at_home<0>, Joint>;
  }

  template <class Joint>
  static constexpr auto drift = pitch_of<Joint>() * Joint::template u<0> * Joint::template axis_at_home<0>;

  template <class Joint>
  static constexpr auto bound_drift =
      freed_drift<Joint> -
      pitch_of<Joint>() * part_along(freed_spin<Joint>, Joint::template axis_of_child<0>);
};

} // namespace describe

/// The child rotates about an axis and advances along it in proportion to the angle: `screw<Nut, Ground,
/// axis<Ground::z>, pitch<h>>`. A motor drives the joint by a torque.
template <class Self, class Parent, class... Words>
struct screw : describe::joint<Self, Parent, describe::screw_joint, Words...> {};

} // namespace kanexpr
