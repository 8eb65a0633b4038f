#pragma once

#include <kanexpr/describe/system.hpp>
#include <kanexpr/joints/joint.hpp>

namespace kanexpr {

namespace describe {

/// Auxiliary speeds of a joint's point and frame along the axes of the child, and the records with them.
template <class Joint>
struct freed_joint {
  using kind = typename Joint::kind;
  static constexpr speed<name_before<"f1", Joint>> f1{};
  static constexpr speed<name_before<"f2", Joint>> f2{};
  static constexpr speed<name_before<"f3", Joint>> f3{};
  static constexpr speed<name_before<"t1", Joint>> t1{};
  static constexpr speed<name_before<"t2", Joint>> t2{};
  static constexpr speed<name_before<"t3", Joint>> t3{};
  static constexpr auto x = basis(&frame_of<Joint>, 0), y = basis(&frame_of<Joint>, 1),
                        z = basis(&frame_of<Joint>, 2);
  static constexpr auto by_force = f1 * x + f2 * y + f3 * z,
                        by_torque = t1 * own::x + t2 * own::y + t3 * own::z;

  static constexpr frame_record frame = [] {
    frame_record r = frame_of<Joint>;
    r.reference = r.parent;
    if constexpr (requires { kind::template spin<Joint>; })
      r.angular_velocity = phrase_of<kind::template spin<Joint> + by_torque>;
    else
      r.angular_velocity = phrase_of<by_torque>;
    return r;
  }();

  static constexpr point_record point = [] {
    point_record r = *Joint::joint_point();
    r.reference = Joint::parent_frame();
    if constexpr (requires { kind::template drift<Joint>; })
      r.velocity = phrase_of<kind::template drift<Joint> + by_force>;
    else
      r.velocity = phrase_of<by_force>;
    r.from_parent = true;
    return r;
  }();
};

template <class Joint>
inline constexpr reaction_record reaction_of = [] {
  reaction_record r;
  r.called = type_name<Joint>();
  if constexpr (requires { Joint::joint_told(); }) {
    using freed = freed_joint<Joint>;
    r.joint = &joint_of<Joint>;
    r.frame = &frame_of<Joint>;
    r.freed_frame = &freed::frame;
    r.point = Joint::joint_point();
    r.freed_point = &freed::point;
    r.speeds = list_of<phrase, &phrase_of<freed::f1>, &phrase_of<freed::f2>, &phrase_of<freed::f3>,
                       &phrase_of<freed::t1>, &phrase_of<freed::t2>, &phrase_of<freed::t3>>::all;
  }
  return r;
}();

} // namespace describe

/// Gives joints auxiliary speeds, six each: the noncontributing forces of the system are then the forces and
/// torques that these joints carry, by their components in the axes of the child.
template <class... Joints>
struct reactions : describe::system_words {
  static constexpr std::string_view word = "reactions";
  static constexpr void tell(describe::system_record& r) {
    r.reactions = describe::list_of<describe::reaction_record, &describe::reaction_of<Joints>...>::all;
  }
};

} // namespace kanexpr
