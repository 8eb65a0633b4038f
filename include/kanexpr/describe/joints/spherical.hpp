#pragma once

#include <kanexpr/describe/joints/joint.hpp>
#include <kanexpr/describe/motion.hpp>

#include <cstddef>
#include <string_view>
#include <type_traits>

namespace kanexpr {

namespace describe {
struct turns_freely {};
} // namespace describe

/// Three angles instead of the unit quaternion of a freely turning joint: `angles<"zxz">`, about successive
/// axes of the child. All twelve sequences are supported.
template <text sequence>
struct angles {
  static constexpr describe::joint_word joint_word = describe::joint_word::special;
  using special = describe::turns_freely;
  static constexpr std::string_view twice = "has two sequences of angles";
  static constexpr std::string_view misplaced =
      "has angles<...>, which belongs to a freely turning joint, spherical<...> or floating<...>";
  static constexpr void turn_by(describe::frame_record& r) {
    r.orientation = describe::orientation_word::body_fixed;
    describe::set_sequence(r, sequence.view());
  }
};

namespace describe {

/// The orientation of a child that rotates freely. Its coordinates start at index `first_q`; the components
/// of its angular velocity relative to its home, in its own axes, start at index `first_u`.
template <bool by_angles, std::size_t first_q, std::size_t first_u>
struct free_orientation {
  using special = turns_freely;

  template <class Joint>
  static constexpr auto spin = Joint::template u<first_u> * own::x + Joint::template u<first_u + 1> * own::y +
                               Joint::template u<first_u + 2> * own::z;
  template <class Joint>
  static constexpr auto bound_spin = 0.0 * own::x;

  template <class Joint>
  static constexpr void turn(frame_record& r) {
    if constexpr (by_angles) {
      Joint::template word<joint_word::special>::turn_by(r);
      r.given_as = "an angle of frame ";
      give<Joint, 0, 1, 2>(r);
    } else { // the scalar part comes last in the state
      r.orientation = orientation_word::quaternion;
      r.given_as = "the quaternion of frame ";
      give<Joint, 3, 0, 1, 2>(r);
    }
    r.reference = Joint::home_frame();
    r.angular_velocity = phrase_of<spin<Joint>, Joint>;
  }

  template <class Joint, std::size_t... index>
  static constexpr void give(frame_record& r) {
    int next = 0;
    ((r.given[next++] = phrase_of<Joint::template q<first_q + index>, Joint>), ...);
  }

  template <class Joint>
  static constexpr auto kinematics_of_orientation =
      kinematics_between(Joint::child_frame(), Joint::home_frame(), !is_known_to_all_files<Joint>);
};

template <class... Words>
inline constexpr bool has_angles =
    !std::is_void_v<typename joint_word_among<joint_word::special, Words...>::type>;

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
