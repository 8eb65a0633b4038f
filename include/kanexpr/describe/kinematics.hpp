#pragma once

#include <kanexpr/describe/frame.hpp>

namespace kanexpr {

namespace describe {

/// A frame and the one from which its orientation and its declared angular velocity are given.
struct turning {
  token tokens[2];
};

constexpr shape shape_of(const turning&) { return shape::turning; }

constexpr turning turning_of(const frame_record* frame, const frame_record* reference) {
  turning both{{with(token_kind::angular_velocity), with(token_kind::angular_velocity)}};
  both.tokens[0].frame = frame;
  both.tokens[1].frame = reference;
  return both;
}

} // namespace describe

/// The kinematic differential equations of a frame whose angular velocity is declared: what follows from its
/// orientation in `Reference` equals what `angular_velocity<Reference, …>` says. Three equations, or four for
/// a quaternion: `kinematics<kinematics_of<B, N>, dot(q4) == u4>`.
template <class Frame, class... Reference>
inline constexpr describe::turning kinematics_of = describe::turning_of(&describe::frame_of<Frame>, nullptr);

template <class Frame, class Reference>
inline constexpr describe::turning kinematics_of<Frame, Reference> =
    describe::turning_of(&describe::frame_of<Frame>, &describe::frame_of<Reference>);

} // namespace kanexpr
