#pragma once

#include <kanexpr/mechanics/loads/force_system.hpp>
#include <kanexpr/mechanics/loads/load_check.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

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

  constexpr expression potential_energy(const mechanism& m) const { return m.zero(); }

  constexpr void check_with(load_check& by, int) const {
    if (against == point) by.fail({"a force acts between point ", by.point(point), " and itself"});
    if (against == none) return by.free_of_speed_rates(value, "the force at ", by.point(point));
    by.free_of_speed_rates(value, "the force between ", by.both_points(point, against).view());
  }

  template <class Visit>
  constexpr void each_point(Visit&& visit) const {
    visit(point);
    if (against != none) visit(against);
  }
  template <class Visit>
  constexpr void each_vector(const mechanism& m, Visit&& visit) const {
    visit(value, "a force on ", m.points[point].called.view());
  }
};

} // namespace kanexpr::mechanics
