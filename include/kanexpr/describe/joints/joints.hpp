#pragma once

#include <kanexpr/describe/joints/joint.hpp>
#include <kanexpr/describe/point.hpp>
#include <kanexpr/describe/system.hpp>

#include <string_view>

namespace kanexpr {

/// The inertial frame and a point fixed in it, as one type to which joints are attached: `struct Ground :
/// inertial_ground<Ground> {};`
template <class Self>
struct inertial_ground : describe::axes<Self>, describe::place_words, describe::ground_words {
  static constexpr describe::frame_record orientation() {
    describe::frame_record r;
    r.declared_name = type_name<Self>();
    return r;
  }
  static constexpr describe::point_record place() {
    describe::point_record r;
    r.declared_name = type_name<Self>();
    r.origin_of = &describe::frame_of<Self>;
    return r;
  }
};

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

template <class Joint, std::size_t index>
constexpr auto coordinate_of() {
  if constexpr (!requires { Joint::coordinates_count; })
    return scalar<1>{{misused_with<Joint>(misuse::no_joint)}};
  else if constexpr (index == 0 || index > Joint::coordinates_count)
    return scalar<1>{{misused_with<Joint>(misuse::no_such_coordinate)}};
  else
    return Joint::template q<index - 1>;
}
template <class Joint, std::size_t index>
constexpr auto speed_of() {
  if constexpr (!requires { Joint::speeds_count; })
    return scalar<1>{{misused_with<Joint>(misuse::no_joint)}};
  else if constexpr (index == 0 || index > Joint::speeds_count)
    return scalar<1>{{misused_with<Joint>(misuse::no_such_speed)}};
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
