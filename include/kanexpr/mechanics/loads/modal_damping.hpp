#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/loads/force_system.hpp>
#include <kanexpr/mechanics/loads/load_check.hpp>
#include <kanexpr/mechanics/loads/load_units.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/wording.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>
#include <kanexpr/units/si.hpp>

namespace kanexpr::mechanics {

/// Structural damping of a flexible body: the generalized forces −D q̇ of its amplitudes q, which dissipate
/// the power q̇·D·q̇.
struct modal_damping {
  sequence<expression> amplitudes{};
  symbolic::matrix damping{}; ///< D

  constexpr void act(force_system& on, conservative) const {
    const skeleton& s = on.skeleton_used();
    const mechanism& m = *s.model;
    sequence<expression> forces(m.coordinates.size(), m.zero());
    for (int i = 0; i < amplitudes.size(); ++i) {
      expression& force = forces[m.coordinates.find(amplitudes[i])];
      for (int j = 0; j < amplitudes.size(); ++j)
        force -= on.known(damping(i, j)) * s.coordinate_rates[m.coordinates.find(amplitudes[j])];
    }
    on.add_coordinate_forces(forces);
  }

  constexpr void check_with(load_check& by, int) const {
    const mechanism& m = by.mechanism_used();
    for (int i = 0; i < amplitudes.size(); ++i)
      for (int j = 0; j < amplitudes.size(); ++j)
        by.check_no_speed_rates(damping(i, j), "the modal damping of ", called(m, amplitudes[i]));
  }

  constexpr void state_units(load_units& by, int) const {
    const mechanism& m = by.mechanism_used();
    for (int i = 0; i < amplitudes.size(); ++i) {
      const expression rate = m.coordinate_rates[m.coordinates.find(amplitudes[i])];
      by.suggest_coefficient(damping(i, i), rate, units::si::watt);
    }
  }
};

} // namespace kanexpr::mechanics
