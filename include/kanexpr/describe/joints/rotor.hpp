#pragma once

#include <kanexpr/describe/joints/joint_word.hpp>
#include <kanexpr/describe/record.hpp>

#include <cstddef>

namespace kanexpr {

/// The rotor of a motor that drives a joint with one coordinate, among the words of the joint: `rotor<J, n>`.
/// The rotor, with the inertia J about its axis, turns n times as fast as the joint, or by n radians per unit
/// of length; without n, as fast. Its inertia n² J acts on the joint's coordinate; the rotation of the rotor
/// with the parent and its gyroscopic moment are neglected, as is usual for high gear ratios.
template <auto... inertia_and_ratio>
struct rotor {
  static constexpr describe::joint_word joint_word = describe::joint_word::rotor;
  static constexpr std::size_t count = sizeof...(inertia_and_ratio);
  static constexpr const describe::phrase* given = describe::given_phrases<inertia_and_ratio...>;
};

} // namespace kanexpr
