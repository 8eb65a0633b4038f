#pragma once

#include <kanexpr/mechanics/loads/force_system.hpp>
#include <kanexpr/mechanics/loads/load_check.hpp>
#include <kanexpr/mechanics/loads/load_units.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/units/si.hpp>

namespace kanexpr::mechanics {

/// A potential energy given as an expression of coordinates, parameters, time and inputs.
struct given_potential_energy {
  expression value{};

  constexpr void act(force_system& on, conservative how) const {
    if (how == conservative::by_forces) on.add_potential_energy(value);
  }

  constexpr expression potential_energy(const mechanism&) const { return value; }

  /// `place` is the index among the potential energies.
  constexpr void check_with(load_check& by, int place) const {
    by.check_no_rates(value, "potential energy ", base::counted(place + 1).view());
  }

  constexpr void state_units(load_units& by, int place) const {
    by.describe({"potential energy ", base::counted(place + 1).view()});
    by.expect(value, units::joule);
  }
};

/// The energy of a torsional spring that is unloaded at the angle `rest`.
constexpr given_potential_energy torsional_spring(expression angle, expression stiffness, expression rest) {
  const expression twist = angle - rest;
  return {stiffness * (twist * twist) / 2};
}

} // namespace kanexpr::mechanics
