#pragma once

#include <kanexpr/describe/joints/joint.hpp>
#include <kanexpr/describe/load.hpp>

#include <string_view>

/// Loads along the axis of a joint, which act on the child and, with opposite sign, on the parent.
namespace kanexpr {

namespace describe {

template <class Joint>
inline constexpr auto chosen_effort = [] {
  if constexpr (effort_of_joint<Joint>() == joint_effort::force)
    return input<joint_name<"F", Joint>>{};
  else
    return input<joint_name<"T", Joint>>{};
}();

/// `value` is the torque or force along the axis.
template <class Load, class Joint, auto value>
constexpr load_record load_along_axis(std::string_view word) {
  load_record r;
  r.word = word;
  r.once = true;
  if constexpr (effort_of_joint<Joint>() == joint_effort::none) {
    r.what = load_word::none;
    r.called = type_name<Load>();
    r.instead = "for a joint that turns about one axis or slides along one";
  } else {
    r.value = phrase_of<whole_argument(value) * Joint::template axis_of_child<0>, Joint>;
    if constexpr (effort_of_joint<Joint>() == joint_effort::torque) {
      r.what = load_word::torque;
      r.frame = Joint::child_frame();
      r.other_frame = Joint::parent_frame();
    } else {
      r.what = load_word::force;
      r.point = Joint::joint_point();
      r.other_point = Joint::base_point();
    }
  }
  return r;
}

template <class Joint, auto... effort>
constexpr auto effort_given() {
  if constexpr (sizeof...(effort) == 0)
    return chosen_effort<Joint>;
  else
    return one_of<0, effort...>();
}

template <class Joint, auto... damping>
constexpr auto friction_of_joint() {
  if constexpr (effort_of_joint<Joint>() == joint_effort::none || sizeof...(damping) == 0)
    return 0.0 * own::x;
  else
    return -(whole_argument(one_of<0, damping...>()) * Joint::template u<0>);
}

} // namespace describe

/// The default input of a motor: T_Link2, or F_Link2 for a sliding joint.
template <class Joint>
inline constexpr auto effort_of = describe::chosen_effort<Joint>;

/// A motor in a joint with one axis: a torque about the axis or a force along it, which acts on the child
/// and, with opposite sign, on the parent. `motor<Link2, T2>`, or `motor<Link2>` with the input
/// `effort_of<Link2>`.
template <class Joint, auto... effort>
struct motor : describe::load_words {
  static constexpr describe::load_record load = [] {
    describe::load_record r =
        describe::load_along_axis<motor, Joint, describe::effort_given<Joint, effort...>()>("the motor");
    r.fits = describe::arguments_of("motor<Joint, torque or force>", sizeof...(effort), 0, 1);
    return r;
  }();
};

/// Viscous friction in a joint with one axis: −c u about or along the axis, where u is the joint's speed.
template <class Joint, auto... damping>
struct joint_friction : describe::load_words {
  static constexpr describe::load_record load = [] {
    describe::load_record r =
        describe::load_along_axis<joint_friction, Joint, describe::friction_of_joint<Joint, damping...>()>(
            "the friction");
    r.fits = describe::arguments_of("joint_friction<Joint, damping>", sizeof...(damping), 1);
    return r;
  }();
};

} // namespace kanexpr
