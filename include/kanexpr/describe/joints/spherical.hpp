#pragma once

#include <kanexpr/describe/joints/orientation.hpp>

#include <string_view>
#include <type_traits>

namespace kanexpr {

namespace describe {

template <bool by_angles>
struct spherical_joint : free_orientation<by_angles, 0, 0> {
  using symbols =
      joint_symbols<std::conditional_t<by_angles, names<"q1", "q2", "q3">, names<"e1", "e2", "e3", "e0">>,
                    names<"w1", "w2", "w3">>;
  static constexpr std::string_view form =
      by_angles ? "spherical<Self, Parent, angles<sequence>, by<three angles, three speeds>>, without an axis"
                : "spherical<Self, Parent, by<e1, e2, e3, e0, three speeds>>, without an axis";
  static constexpr std::size_t least_axes = 0, most_axes = 0;
  static constexpr bool moves = false;

  template <class Joint>
  static constexpr listing<phrase> kinematics() {
    return list_of<phrase,
                   &phrase_of<spherical_joint::template kinematics_of_orientation<Joint>, Joint>>::all;
  }
};

} // namespace describe

/// A ball joint: the child rotates freely about a point. Its coordinates are the components of a unit
/// quaternion, e1, e2, e3, e0, or three angles with `angles<"zxz">`; its speeds are the components of its
/// angular velocity relative to the parent, in its own axes.
template <class Self, class Parent, class... Words>
struct spherical
    : describe::joint<Self, Parent, describe::spherical_joint<describe::has_angles<Words...>>, Words...> {};

} // namespace kanexpr
