#pragma once

#include <kanexpr/describe/joints/joint.hpp>
#include <kanexpr/describe/kinematics.hpp>

#include <string_view>
#include <type_traits>

/// The orientation of a freely turning child relative to its home: a unit quaternion or three angles.
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
    for (std::size_t i = 0; i < 3 && i < sequence.view().size(); ++i) r.sequence[i] = sequence.letters[i];
    if (sequence.view().size() != 3) r.sequence[0] = '?';
  }
};

namespace describe {

/// A freely turning child. Its orientation coordinates start at index `first_q`; the components of its
/// angular velocity relative to its home, in its own axes, start at index `first_u`.
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
      r.given[0] = phrase_of<Joint::template q<first_q>, Joint>;
      r.given[1] = phrase_of<Joint::template q<first_q + 1>, Joint>;
      r.given[2] = phrase_of<Joint::template q<first_q + 2>, Joint>;
    } else { // the scalar part comes last in the state
      r.orientation = orientation_word::quaternion;
      r.given_as = "the quaternion of frame ";
      r.given[0] = phrase_of<Joint::template q<first_q + 3>, Joint>;
      r.given[1] = phrase_of<Joint::template q<first_q>, Joint>;
      r.given[2] = phrase_of<Joint::template q<first_q + 1>, Joint>;
      r.given[3] = phrase_of<Joint::template q<first_q + 2>, Joint>;
    }
    r.reference = Joint::home_frame();
    r.angular_velocity = phrase_of<spin<Joint>, Joint>;
  }

  template <class Joint>
  static constexpr auto kinematics_of_orientation =
      kinematics_between(Joint::child_frame(), Joint::home_frame(), !is_known_to_all_files<Joint>);
};

template <class... Words>
inline constexpr bool has_angles =
    !std::is_void_v<typename joint_word_among<joint_word::special, Words...>::type>;

} // namespace describe

} // namespace kanexpr
