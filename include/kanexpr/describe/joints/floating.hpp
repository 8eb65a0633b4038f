#pragma once

#include <kanexpr/describe/joints/spherical.hpp>

#include <string_view>
#include <type_traits>

namespace kanexpr {

namespace describe {

template <bool by_angles>
struct floating_joint : free_orientation<by_angles, 3, 3> {
  using symbols = joint_symbols<std::conditional_t<by_angles, names<"p1", "p2", "p3", "q1", "q2", "q3">,
                                                   names<"p1", "p2", "p3", "e1", "e2", "e3", "e0">>,
                                names<"v1", "v2", "v3", "w1", "w2", "w3">>;
  static constexpr std::string_view form =
      by_angles ? "floating<Self, Parent, angles<sequence>, by<position, three angles, six speeds>>, without "
                  "an axis"
                : "floating<Self, Parent, by<position, e1, e2, e3, e0, six speeds>>, without an axis";
  static constexpr std::size_t least_axes = 0, most_axes = 0;
  static constexpr bool moves = true;

  template <class Joint>
  static constexpr auto drift = Joint::template u<0> * basis(Joint::child_frame(), 0) +
                                Joint::template u<1> * basis(Joint::child_frame(), 1) +
                                Joint::template u<2> * basis(Joint::child_frame(), 2);
  template <class Joint>
  static constexpr auto bound_drift = 0.0 * basis(Joint::child_frame(), 0);

  template <class Joint>
  static constexpr void move(point_record& r) {
    r.offset = phrase_of<Joint::template q<0> * basis(Joint::home_frame(), 0) +
                             Joint::template q<1> * basis(Joint::home_frame(), 1) +
                             Joint::template q<2> * basis(Joint::home_frame(), 2),
                         Joint>;
    r.reference = Joint::parent_frame();
    r.velocity = phrase_of<drift<Joint>, Joint>;
    r.from_parent = true;
  }

  template <class Joint, std::size_t index>
  static constexpr auto rate_of_position =
      dot(Joint::template q<index>) == dot(drift<Joint>, basis(Joint::home_frame(), static_cast<int>(index)));

  template <class Joint>
  static constexpr listing<phrase> kinematics() {
    return list_of<phrase, &phrase_of<rate_of_position<Joint, 0>, Joint>,
                   &phrase_of<rate_of_position<Joint, 1>, Joint>,
                   &phrase_of<rate_of_position<Joint, 2>, Joint>,
                   &phrase_of<floating_joint::template kinematics_of_orientation<Joint>, Joint>>::all;
  }
};

} // namespace describe

/// A joint with six degrees of freedom, such as the base of a walking robot. Its coordinates are the position
/// p1, p2, p3 in the axes of its home and a unit quaternion e1, e2, e3, e0, or three angles with
/// `angles<"zyx">`. Its speeds are the components of its velocity and of its angular velocity relative to the
/// parent, in its own axes. (It is not called `free` because that is the name of a C library function.)
template <class Self, class Parent, class... Words>
struct floating
    : describe::joint<Self, Parent, describe::floating_joint<describe::has_angles<Words...>>, Words...> {};

} // namespace kanexpr
