#pragma once

#include <kanexpr/mechanics/model/vector.hpp>

namespace kanexpr::mechanics {

/// A velocity constraint: a scalar, linear in the speeds, that vanishes. Where it is the component of a
/// vector along a direction, both are kept, for the rate of the vector is cheaper to form than that of the
/// scalar.
struct velocity_constraint {
  expression value{};
  vector vanishing{}; ///< no parts: there is only the scalar
  vector direction{};
};

/// What binds a mechanism, as it was given.
struct given_constraints {
  sequence<expression> on_configuration{};   ///< of coordinates, parameters and time, that vanish
  sequence<expression> rates_by_auxiliary{}; ///< what auxiliary speeds add to their rates; empty: nothing
  sequence<velocity_constraint> on_velocities{};
  sequence<expression> on_accelerations{}; ///< linear in u̇, that vanish; empty: derived from the others
  sequence<int> redundant{}; ///< configuration constraints that follow from the others, counted from 1 on
  sequence<int> dependent_coordinates{}, dependent_speeds{}; ///< by position; empty: the library chooses
};

} // namespace kanexpr::mechanics
