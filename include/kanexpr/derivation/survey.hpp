#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/derivation/inertial_values.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

namespace kanexpr::mechanics {
class equations;
struct multibody_system;
} // namespace kanexpr::mechanics

namespace kanexpr::derivation {

class derived_system;

/// The properties of a system that are known before anything is derived: its symbols in order, and its first
/// mistake.
struct survey {
  static constexpr int room = 512;

  base::sentence mistake{};
  bool takes_rates_as_speeds = false; ///< as in Lagrange's method
  int coordinates = 0;
  int speeds = 0;          ///< including state variables
  int state_variables = 0; ///< the last of the speeds
  int parameters = 0;
  int inputs = 0;
  int auxiliary_speeds = 0;
  int constraints = 0; ///< constraints on the speeds, including the rates of configuration constraints
  int nonlinear_constraints = 0; ///< constraints on the speeds that are not linear in them
  int configuration_constraints = 0;
  int redundant_constraints = 0;
  int inertial_parameters = 0;
  base::name names[room]{};   ///< coordinates, speeds, parameters, inputs
  bool dependent[room]{};     ///< in the same order
  bool is_mass[room]{};       ///< whether the symbol is the mass of a body
  bool is_moment[room]{};     ///< whether the symbol is a moment of inertia
  inertial_values inertial{}; ///< masses and moments that are longer expressions
  int quaternions = 0;        ///< unit quaternions, whose norm the motion preserves
  int quaternion_of[room]{};  ///< for each coordinate: the number of its quaternion, counted from 1; 0 if
                              ///< there is none
  bool states_units = false;  ///< whether the unit of any symbol is stated or implied
  bool checks_units = false;  ///< whether the model states the unit of any symbol

  /// The number of independent coordinates and speeds.
  constexpr int states() const { return coordinates - configuration_constraints + speeds - constraints; }
  /// The index of the first state variable in the state.
  constexpr int first_state_variable() const { return coordinates + speeds - state_variables; }
  /// Whether a list of values may omit a symbol: the constraints determine dependent coordinates and speeds,
  /// and state variables start at zero.
  constexpr bool may_be_omitted(int symbol) const {
    return dependent[symbol] || (symbol >= first_state_variable() && symbol < coordinates + speeds);
  }
  /// The number of rates and multipliers in the linearized equations.
  constexpr int unknowns() const { return coordinates + speeds + (takes_rates_as_speeds ? constraints : 0); }
  constexpr int symbols() const { return coordinates + speeds + parameters + inputs; }

  /// The number of rows or columns of a result.
  constexpr int count(mechanics::extent_by what) const {
    using mechanics::extent_by;
    switch (what) {
    case extent_by::scalar:
    case extent_by::one: return 1;
    case extent_by::three: return 3;
    case extent_by::coordinates: return coordinates;
    case extent_by::speeds: return speeds;
    case extent_by::coordinates_and_speeds: return coordinates + speeds;
    case extent_by::independent_speeds: return speeds - constraints;
    case extent_by::configuration_constraints: return configuration_constraints;
    case extent_by::speed_constraints: return constraints;
    case extent_by::all_constraints: return configuration_constraints + constraints;
    case extent_by::auxiliary_speeds: return auxiliary_speeds;
    case extent_by::inputs: return inputs;
    case extent_by::independent_states: return states();
    case extent_by::unknowns: return unknowns();
    case extent_by::state_and_inputs: return coordinates + speeds + inputs;
    case extent_by::redundant_constraints: return redundant_constraints;
    case extent_by::inertial_parameters: return inertial_parameters;
    }
    return 0;
  }

  constexpr void take(derived_system& system);
  /// Takes the properties from a system and its equations; `derived` is null if a mistake occurred before the
  /// equations were formed.
  constexpr void take(const mechanics::multibody_system& of, bool is_sound,
                      const mechanics::equations* derived);

  /// The index in `names` of the first symbol of a kind; rates share the names of the coordinates.
  constexpr int first_of(symbolic::symbol_kind kind) const {
    using symbolic::symbol_kind;
    return kind == symbol_kind::speed       ? coordinates
           : kind == symbol_kind::parameter ? coordinates + speeds
           : kind == symbol_kind::input     ? coordinates + speeds + parameters
                                            : 0;
  }
  constexpr int count_of(symbolic::symbol_kind kind) const {
    using symbolic::symbol_kind;
    return kind == symbol_kind::coordinate        ? coordinates
           : kind == symbol_kind::coordinate_rate ? (takes_rates_as_speeds ? coordinates : 0)
           : kind == symbol_kind::speed           ? speeds
           : kind == symbol_kind::parameter       ? parameters
           : kind == symbol_kind::input           ? inputs
                                                  : 0;
  }
  /// The position of a symbol among those of its kind, or -1. Rates of coordinates are identified by the
  /// names of the coordinates.
  constexpr int place(symbolic::symbol_kind kind, const base::name& called) const {
    for (int i = 0; i < count_of(kind); ++i)
      if (names[first_of(kind) + i] == called) return i;
    return -1;
  }
};

} // namespace kanexpr::derivation
