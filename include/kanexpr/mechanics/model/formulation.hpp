#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/operation_weights.hpp>

/// How the equations of motion are formed. The motion does not depend on it, but the number of operations
/// does.
namespace kanexpr::mechanics {

using base::sequence;

/// How u̇ follows from the equations of motion of a tree of rigid bodies without constraints.
enum class solution : unsigned char {
  cheapest,           ///< the one with fewer operations, if it is worth the time to form both
  elimination,        ///< M = LᵀDL
  articulated_bodies, ///< Featherstone (2008), chapter 7
};

/// The speeds for which equations are formed and solved.
enum class internal_speeds : unsigned char {
  given,    ///< those of the model
  absolute, ///< angular velocities in the ground, for bodies that rotate about parallel axes
};

/// The equations of all bodies that move with one frame.
struct formulation_of_frame {
  int frame = -1;
  int axes = -1;                 ///< the frame in whose axes they are written; -1: chosen by the library
  bool about_the_center = false; ///< about the mass center instead of the joint
};

/// The form of the equations, as far as the model or a search determines it.
struct formulation {
  solution solved_by = solution::cheapest;
  internal_speeds speeds = internal_speeds::given;
  sequence<formulation_of_frame> frames{};
  symbolic::operation_weights weights{};

  constexpr const formulation_of_frame* of(int frame) const {
    for (const formulation_of_frame& f : frames)
      if (f.frame == frame) return &f;
    return nullptr;
  }
  /// The entry of a frame, which is added if it is missing.
  constexpr formulation_of_frame& entry(int frame) {
    for (formulation_of_frame& f : frames)
      if (f.frame == frame) return f;
    frames.push({frame, -1, false});
    return frames.back();
  }
};

} // namespace kanexpr::mechanics
