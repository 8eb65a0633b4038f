#pragma once

#include <kanexpr/describe/joints/joint.hpp>
#include <kanexpr/describe/system.hpp>

#include <string_view>

namespace kanexpr {

/// The joints of a system. Their coordinates, speeds, kinematic equations and bodies follow those that the
/// system itself lists, in the order of the joints.
template <class... Joints>
struct joints : describe::system_words {
  static constexpr std::string_view word = "joints";
  static constexpr void add_to(describe::system_record& r) {
    r.joints = describe::list_of<describe::joint_record, &describe::joint_of<Joints>...>::all;
  }
};

namespace describe {

/// Takes the place of a symbol that a joint does not have.
template <class Joint>
constexpr scalar<1> no_symbol_of(misuse what) {
  return {{misused_with<Joint>(what)}};
}

template <class Joint, std::size_t index>
constexpr auto coordinate_of() {
  if constexpr (!requires { Joint::coordinates_count; })
    return no_symbol_of<Joint>(misuse::no_joint);
  else if constexpr (index == 0 || index > Joint::coordinates_count)
    return no_symbol_of<Joint>(misuse::no_such_coordinate);
  else
    return Joint::template q<index - 1>;
}
template <class Joint, std::size_t index>
constexpr auto speed_of() {
  if constexpr (!requires { Joint::speeds_count; })
    return no_symbol_of<Joint>(misuse::no_joint);
  else if constexpr (index == 0 || index > Joint::speeds_count)
    return no_symbol_of<Joint>(misuse::no_such_speed);
  else
    return Joint::template u<index - 1>;
}

} // namespace describe

/// Coordinate i of a joint, counted from 1.
template <class Joint, std::size_t index = 1>
inline constexpr auto q_of = describe::coordinate_of<Joint, index>();

/// Speed i of a joint, counted from 1.
template <class Joint, std::size_t index = 1>
inline constexpr auto u_of = describe::speed_of<Joint, index>();

} // namespace kanexpr
