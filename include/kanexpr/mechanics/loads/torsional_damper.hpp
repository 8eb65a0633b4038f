#pragma once

#include <kanexpr/mechanics/loads/force_system.hpp>
#include <kanexpr/mechanics/loads/load_check.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/motion/relative_motion.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::mechanics {

/// A torque −damping·(ω_frame − ω_against) on the body fixed in `frame`, and its opposite on `against`.
struct torsional_damper {
  int frame = none;
  int against = none;
  expression damping{};

  constexpr void act(force_system& on, conservative) const {
    const expression factor = -on.known(damping);
    on.add_torque(frame, against, factor * angular_velocity_between(on.skeleton_used(), frame, against));
  }

  constexpr expression potential_energy(const mechanism& m) const { return m.zero(); }

  constexpr void check_with(load_check& by, int) const {
    if (frame == against) by.fail({"a torsional damper acts between frame ", by.frame(frame), " and itself"});
    by.free_of_speed_rates(damping, "the torsional damping between ", by.both_frames(frame, against).view());
  }

  template <class Visit>
  constexpr void each_point(Visit&&) const {}
  template <class Visit>
  constexpr void each_vector(const mechanism&, Visit&&) const {}
};

} // namespace kanexpr::mechanics
