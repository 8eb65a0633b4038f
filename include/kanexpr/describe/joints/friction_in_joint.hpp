#pragma once

#include <kanexpr/describe/friction.hpp>
#include <kanexpr/describe/joints/motor.hpp>

namespace kanexpr {

namespace describe {

/// The friction along the axis of a joint. The record has the axis as its value, the joint's speed as its
/// angle, and the normal force as its rest.
template <class Load, class Joint, auto normal, class... Law>
constexpr load_record friction_along_axis() {
  load_record r = load_along_axis<Load, Joint, 1>("the friction");
  r.once = false;
  r.fits = arguments_of("friction<Joint, normal force, law>", sizeof...(Law), 1);
  if constexpr (!(law_of_friction<Law> && ...)) {
    r.what = load_word::none;
    r.called = type_name<Load>();
    r.instead = "incomplete, because its last argument is not a law of friction";
  } else if constexpr (effort_of_joint<Joint>() != joint_effort::none) {
    const friction_record* const laws[]{&friction_of<Law>..., nullptr};
    r.what = load_word::friction;
    r.value = phrase_of<Joint::template axis_of_child<0>, Joint>;
    r.angle = phrase_of<Joint::template u<0>, Joint>;
    r.rest = phrase_of<normal>;
    r.friction = laws[0];
    if (r.fits && r.friction != nullptr) r.fits = r.friction->fits;
  }
  return r;
}

} // namespace describe

/// Friction in a joint with one axis: the torque or force −N μ(u) about or along the axis, where u is the
/// joint's speed, on the child and, with opposite sign, on the parent. N is a normal force times the radius
/// at which it acts, or a normal force if the joint slides; with N = 1 the law gives the torque or force
/// itself. `friction<Link2, N, coulomb_friction<mu, ws>>`
template <class Joint, auto normal, class... Law>
struct friction : describe::load_words {
  static constexpr describe::load_record load =
      describe::friction_along_axis<friction, Joint, normal, Law...>();
};

} // namespace kanexpr
