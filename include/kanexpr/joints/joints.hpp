#pragma once

#include <kanexpr/describe/system.hpp>
#include <kanexpr/joints/joint.hpp>

namespace kanexpr {

/// The joints of a system. Their coordinates, speeds and kinematic equations come behind those that the
/// system lists itself, in the order of the joints, and their bodies behind its bodies.
template <class... Joints>
struct joints : describe::system_words {
  static constexpr std::string_view word = "joints";
  static constexpr void tell(describe::system_record& r) {
    r.joints = describe::list_of<describe::joint_record, &describe::joint_of<Joints>...>::all;
  }
};

/// Coordinate i of a joint, from 1.
template <class Joint, std::size_t index = 1>
inline constexpr auto q_of = Joint::template q<index - 1>;

/// Speed i of a joint, from 1.
template <class Joint, std::size_t index = 1>
inline constexpr auto u_of = Joint::template u<index - 1>;

} // namespace kanexpr
