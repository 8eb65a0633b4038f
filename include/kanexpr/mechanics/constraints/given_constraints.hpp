#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/vector.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::mechanics {

/// A velocity constraint: a scalar that depends on the speeds and vanishes. If it is the component of a
/// vector along a direction, the vector and the direction are stored, too, because the rate of the vector is
/// cheaper to form than that of the scalar.
struct velocity_constraint {
  expression value{};
  vector vanishing{}; ///< has no parts if only the scalar is given
  vector direction{};
};

/// The constraints of a mechanism, as given.
struct given_constraints {
  sequence<expression> on_configuration{};   ///< expressions of coordinates, parameters and time that vanish
  sequence<expression> rates_by_auxiliary{}; ///< the contribution of auxiliary speeds to the rates of these
                                             ///< constraints; empty if there is none
  sequence<velocity_constraint> on_velocities{};
  sequence<expression> on_accelerations{}; ///< expressions linear in u̇ that vanish; if empty, they are
                                           ///< derived from the others
  sequence<int> redundant{}; ///< configuration constraints that follow from the others, numbered from 1
  sequence<int> dependent_coordinates{},
      dependent_speeds{}; ///< as indices; if empty, the library chooses them
};

} // namespace kanexpr::mechanics
