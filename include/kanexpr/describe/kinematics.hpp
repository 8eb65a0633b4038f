#pragma once

#include <kanexpr/describe/frame.hpp>

namespace kanexpr {

namespace describe {

/// A frame, and the frame relative to which its orientation and its declared angular velocity are given.
using kinematics_of_frame = postfix<shape::kinematics, 2>;

constexpr kinematics_of_frame kinematics_between(const frame_record* frame, const frame_record* reference,
                                                 bool is_of_one_file) {
  kinematics_of_frame both{{with(token_kind::angular_velocity), with(token_kind::angular_velocity)}};
  both.tokens[0].frame = frame;
  both.tokens[1].frame = reference;
  both.tokens[0].is_of_one_file = is_of_one_file;
  return both;
}

} // namespace describe

/// `kinematics<simple>` adds the kinematic differential equations q̇ = u of all coordinates whose rates
/// appear in no other equation. The first of these coordinates is paired with the first speed that appears in
/// no other equation, and so on.
inline constexpr describe::postfix<describe::shape::simple, 1> simple{
    {describe::with(describe::token_kind::number)}};

/// The kinematic differential equations of a frame whose angular velocity is declared: the angular velocity
/// that follows from its orientation in `Reference` equals the one in `angular_velocity<Reference, …>`. These
/// are three equations, or four for a quaternion: `kinematics<kinematics_of<B, N>, dot(q4) == u4>`.
template <class Frame, class... Reference>
inline constexpr describe::kinematics_of_frame kinematics_of =
    describe::kinematics_between(&describe::frame_of<Frame>, nullptr, !is_known_to_all_files<Frame>);

template <class Frame, class Reference>
inline constexpr describe::kinematics_of_frame kinematics_of<Frame, Reference> =
    describe::kinematics_between(&describe::frame_of<Frame>, &describe::frame_of<Reference>,
                                 !is_known_to_all_files<Frame> || !is_known_to_all_files<Reference>);

} // namespace kanexpr
