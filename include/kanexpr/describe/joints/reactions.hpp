#pragma once

#include <kanexpr/describe/joints/freed.hpp>
#include <kanexpr/describe/system.hpp>

#include <string_view>

namespace kanexpr {

namespace describe {

/// The frame and the point of a joint, with auxiliary speeds in all directions that the joint constrains.
template <class Joint>
struct freed_joint {
  using kind = typename Joint::kind;

  static constexpr auto bound_spin() {
    if constexpr (requires { kind::template bound_spin<Joint>; })
      return kind::template bound_spin<Joint>;
    else
      return freed_spin<Joint>;
  }
  static constexpr auto bound_drift() {
    if constexpr (requires { kind::template bound_drift<Joint>; })
      return kind::template bound_drift<Joint>;
    else
      return freed_drift<Joint>;
  }

  static constexpr frame_record frame = [] {
    frame_record r = frame_of<Joint>;
    r.reference = r.parent;
    if constexpr (requires { kind::template spin<Joint>; })
      r.angular_velocity = phrase_of<kind::template spin<Joint> + bound_spin(), Joint>;
    else
      r.angular_velocity = phrase_of<bound_spin(), Joint>;
    return r;
  }();

  /// Its velocity is relative to the location of the joint in the parent, which may itself move in the
  /// parent.
  static constexpr point_record point = [] {
    point_record r = *Joint::joint_point();
    if constexpr (!kind::moves) {
      r.parent = Joint::base_point();
      r.offset = phrase_of<0.0 * basis(Joint::parent_frame(), 0), Joint>;
    }
    r.reference = Joint::parent_frame();
    if constexpr (requires { kind::template drift<Joint>; })
      r.velocity = phrase_of<kind::template drift<Joint> + bound_drift(), Joint>;
    else
      r.velocity = phrase_of<bound_drift(), Joint>;
    r.from_parent = true;
    return r;
  }();
};

template <class Joint>
inline constexpr reaction_record reaction_of = [] {
  reaction_record r;
  r.called = type_name<Joint>();
  if constexpr (requires { requires Joint::is_written; }) {
    using freed = freed_joint<Joint>;
    using speeds = release_speeds<Joint>;
    r.joint = &joint_of<Joint>;
    r.frame = &frame_of<Joint>;
    r.freed_frame = &freed::frame;
    r.point = Joint::joint_point();
    r.freed_point = &freed::point;
    r.speeds = list_of<phrase, &phrase_of<speeds::f1, Joint>, &phrase_of<speeds::f2, Joint>,
                       &phrase_of<speeds::f3, Joint>, &phrase_of<speeds::t1, Joint>,
                       &phrase_of<speeds::t2, Joint>, &phrase_of<speeds::t3, Joint>>::all;
  }
  return r;
}();

} // namespace describe

/// Adds six auxiliary speeds to each joint. The noncontributing forces of the system are then the reaction
/// forces and torques of these joints, as components in the axes of the child.
template <class... Joints>
struct reactions : describe::system_words {
  static constexpr std::string_view word = "reactions";
  static constexpr void add_to(describe::system_record& r) {
    r.reactions = describe::list_of<describe::reaction_record, &describe::reaction_of<Joints>...>::all;
  }
};

} // namespace kanexpr
