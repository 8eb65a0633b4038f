#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/loads/force_system.hpp>
#include <kanexpr/mechanics/loads/load_check.hpp>
#include <kanexpr/mechanics/loads/load_units.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>
#include <kanexpr/symbolic/printing/short_text.hpp>
#include <kanexpr/units/si.hpp>

namespace kanexpr::mechanics {

/// A potential energy given as an expression of coordinates, parameters, time and inputs.
struct given_potential_energy {
  expression value{};
  bool has_numbers =
      false; ///< whether it may contain numbers with units, as the energy of a flexible body does
  expression angle{}, stiffness{}; ///< of a torsional spring; otherwise not given

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
    if (angle.is_given()) {
      const symbolic::short_text whose(angle.owner(), angle.node());
      by.describe({"the torsional spring with ", whose.view()});
      by.examine(value);
      const bool is_angle = by.is_angle(angle);
      by.describe({"the stiffness of the torsional spring with ", whose.view()});
      if (is_angle) by.expect(stiffness, units::si::newton * units::si::meter / units::si::radian);
      by.describe({"the torsional spring with ", whose.view()});
    }
    if (has_numbers) return by.suggest(value, units::si::joule);
    by.expect(value, units::si::joule);
  }
};

/// The energy of a torsional spring that is unloaded at the angle `rest`.
constexpr given_potential_energy torsional_spring(expression angle, expression stiffness, expression rest) {
  const expression twist = angle - rest;
  return {stiffness * (twist * twist) / 2, stiffness.is_constant(), angle, stiffness};
}

/// The elastic energy ½ q·K·q of a deformation with the amplitudes q and the stiffness K.
constexpr given_potential_energy elastic_energy(const sequence<expression>& amplitudes,
                                                const symbolic::matrix& stiffness) {
  expression twice{stiffness.entries[0].owner(), graph::zero};
  for (int i = 0; i < amplitudes.size(); ++i)
    for (int j = 0; j < amplitudes.size(); ++j) twice += stiffness(i, j) * (amplitudes[i] * amplitudes[j]);
  return {twice / 2, true};
}

} // namespace kanexpr::mechanics
