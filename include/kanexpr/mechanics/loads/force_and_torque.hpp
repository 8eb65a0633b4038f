#pragma once

#include <kanexpr/mechanics/loads/force_system.hpp>
#include <kanexpr/mechanics/loads/load_check.hpp>
#include <kanexpr/mechanics/loads/load_units.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/units/si.hpp>

namespace kanexpr::mechanics {

struct force {
  int point = none;
  vector value{};
  int against = none; ///< the point on which the reaction acts; none: it acts outside the system

  constexpr void act(force_system& on, conservative) const {
    const vector known = on.known(value);
    on.add_force(point, known);
    if (against != none) on.add_force(against, -known);
  }

  constexpr void check_with(load_check& by, int) const {
    if (against == point) by.fail({"a force acts between point ", by.point(point), " and itself"});
    by.check_no_speed_rates(value, "the force ", by.place_of(*this).view());
  }

  constexpr void state_units(load_units& by, int) const {
    by.describe({"the force ", by.place_of(*this).view()});
    by.expect(value, units::si::newton);
  }
};

struct torque {
  int frame = none;
  vector value{};
  int against = none; ///< the frame on which the reaction acts; none: it acts outside the system

  constexpr void act(force_system& on, conservative) const { on.add_torque(frame, against, on.known(value)); }

  constexpr void check_with(load_check& by, int) const {
    if (against == frame) by.fail({"a torque acts between frame ", by.frame(frame), " and itself"});
    by.check_no_speed_rates(value, "the torque ", by.place_of(*this).view());
  }

  constexpr void state_units(load_units& by, int) const {
    by.describe({"the torque ", by.place_of(*this).view()});
    by.expect(value, units::si::newton * units::si::meter);
  }
};

} // namespace kanexpr::mechanics
