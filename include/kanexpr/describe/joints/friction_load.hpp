#pragma once

#include <kanexpr/describe/bristle.hpp>
#include <kanexpr/describe/friction.hpp>
#include <kanexpr/describe/joints/motor.hpp>
#include <kanexpr/describe/path_load.hpp>

namespace kanexpr {

namespace describe {

/// Describes the friction along the axis of a joint. The record has the axis as its value, the joint's speed
/// as its angle, and the normal force as its rest.
template <class Load, class Joint, auto normal>
constexpr load_record friction_along_axis() {
  load_record r = load_along_axis<Load, Joint, 1>("the friction");
  if constexpr (effort_of_joint<Joint>() == joint_effort::none)
    r.instead =
        "for a pathway, such as straight<P, Q>, or a joint that turns about one axis or slides along one";
  if constexpr (effort_of_joint<Joint>() != joint_effort::none) {
    r.what = load_word::friction;
    r.value = phrase_of<Joint::template axis_of_child<0>, Joint>;
    r.angle = phrase_of<Joint::template u<0>, Joint>;
    r.rest = phrase_of<normal>;
  }
  return r;
}

/// Describes the friction along a pathway. The record has the normal force as its rest.
template <class Path, auto normal>
constexpr load_record friction_along_path() {
  load_record r = load_along<Path>(load_word::friction, "the friction", {}, nullptr, 0);
  r.rest = phrase_of<normal>;
  return r;
}

/// Describes friction with bristles. In a joint with one axis, it acts along its coordinate.
template <class Load, class On, auto normal>
constexpr load_record friction_with_bristles() {
  constexpr bool is_along_path = requires { On::path.what; };
  load_record r;
  if constexpr (is_along_path && names_of_bristles_on<On>().first.empty()) {
    r.what = load_word::none;
    r.called = type_name<Load>();
    r.instead = "along a pathway without points, after which its bristles could be named";
  } else if constexpr (is_along_path) {
    r = friction_along_path<On, normal>();
    r.states = bristles_on<On>;
  } else {
    const load_record in_joint = friction_along_axis<Load, On, normal>();
    if constexpr (effort_of_joint<On>() == joint_effort::none) return in_joint;
    r = friction_along_path<On, normal>();
    r.states = bristles_on<On>;
    r.point = in_joint.point, r.other_point = in_joint.other_point;
    r.frame = in_joint.frame, r.other_frame = in_joint.other_frame;
  }
  return r;
}

template <class Load, class On, auto normal, class... Law>
constexpr load_record record_friction() {
  load_record r;
  if constexpr (!(law_of_friction<Law> && ...)) {
    r.what = load_word::none;
    r.called = type_name<Load>();
    r.instead = "incomplete, because its last argument is not a law of friction";
    return r;
  } else {
    if constexpr ((law_with_bristles<Law> || ...))
      r = friction_with_bristles<Load, On, normal>();
    else if constexpr (requires { On::path.what; })
      r = friction_along_path<On, normal>();
    else
      r = friction_along_axis<Load, On, normal>();
    const friction_record* const laws[]{&friction_of<Law>..., nullptr};
    r.once = false;
    r.friction = laws[0];
    r.fits = arguments_of("friction<Joint or Path, normal force, law>", sizeof...(Law), 1);
    if (r.fits) r.fits = r.friction->fits;
    return r;
  }
}

} // namespace describe

/// Friction in a joint with one axis or along a pathway: the force −N μ(v) against the speed v of the joint
/// or the rate of the length of the pathway. In a joint, it is a torque or force about or along the axis on
/// the child and, with opposite sign, on the parent. N is a normal force, for a torque times the radius at
/// which it acts; with N = 1 the law gives the torque or force itself. `friction<Link2, N,
/// coulomb_friction<mu, ws>>`; `dahl_friction` and `lugre_friction` bring the state variable
/// `bristle_of<Link2>`.
template <class On, auto normal, class... Law>
struct friction : describe::load_words {
  static constexpr describe::load_record load = describe::record_friction<friction, On, normal, Law...>();
};

} // namespace kanexpr
