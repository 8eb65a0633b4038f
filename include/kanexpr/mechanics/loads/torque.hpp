#pragma once

#include <kanexpr/mechanics/loads/force_system.hpp>
#include <kanexpr/mechanics/loads/load_check.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::mechanics {

struct torque {
  int frame = none;
  vector value{};
  int against = none; ///< the frame on which the reaction acts; none: it acts outside the system

  constexpr void act(force_system& on, conservative) const { on.add_torque(frame, against, on.known(value)); }

  constexpr expression potential_energy(const mechanism& m) const { return m.zero(); }

  constexpr void check_with(load_check& by, int) const {
    if (against == frame) by.fail({"a torque acts between frame ", by.frame(frame), " and itself"});
    if (against == none) return by.free_of_speed_rates(value, "the torque on ", by.frame(frame));
    by.free_of_speed_rates(value, "the torque between ", by.both_frames(frame, against).view());
  }

  template <class Visit>
  constexpr void each_point(Visit&&) const {}
  template <class Visit>
  constexpr void each_vector(const mechanism& m, Visit&& visit) const {
    visit(value, "a torque on ", m.frames[frame].called.view());
  }
};

} // namespace kanexpr::mechanics
