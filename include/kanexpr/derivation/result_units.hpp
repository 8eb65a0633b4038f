#pragma once

#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/mechanics/units/unit_table.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>
#include <kanexpr/units/si.hpp>
#include <kanexpr/units/unit.hpp>

#include <optional>

namespace kanexpr::derivation {

using mechanics::possible_unit;

constexpr possible_unit operator/(const possible_unit& a, const possible_unit& b) {
  if (!a.has_value() || !b.has_value()) return std::nullopt;
  return *a / *b;
}
constexpr possible_unit operator/(const possible_unit& a, const units::unit& b) {
  return a / possible_unit(b);
}
constexpr possible_unit operator*(const possible_unit& a, const units::unit& b) {
  if (!a.has_value()) return std::nullopt;
  return *a * b;
}
constexpr possible_unit without_angle(const possible_unit& u) {
  if (!u.has_value()) return std::nullopt;
  return units::without_angle(*u);
}

/// The units of the results of a system. A generalized force times its speed is a power, so the forces of a
/// system follow from the units of its speeds, and the entries of matrices are ratios.
class result_units {
public:
  constexpr result_units(const mechanics::unit_table& symbols, const survey& s) : table_(symbols), s_(s) {}

  /// The unit of an entry; nothing if the model does not determine it.
  constexpr possible_unit of(mechanics::quantity wanted, int row = 0, int column = 0) const {
    using q = mechanics::quantity;
    using by = mechanics::extent_by;
    const mechanics::result_row& r = mechanics::row_of(wanted);
    if (!table_.is_stated) return std::nullopt;
    switch (wanted) {
    case q::mass_matrix:
    case q::unreduced_mass_matrix:
      return force(r.rows, row) / without_angle(speed(r.columns, column)) * units::si::second;
    case q::coriolis: return force(r.rows, row) / without_angle(speed(r.columns, column));
    case q::forcing:
    case q::active_forces:
    case q::inertia_forces:
    case q::unreduced_forces:
    case q::unreduced_forcing:
    case q::inverse_dynamics:
    case q::gravity_compensation:
    case q::load_compensation: return force(r.rows, row);
    case q::qdot:
    case q::udot:
    case q::rhs: return state(r.rows, row) / units::si::second;
    case q::required_inputs: return input(row);
    case q::kinetic_energy:
    case q::potential_energy: return units::si::joule;
    case q::linear_momentum: return units::si::newton * units::si::second;
    case q::angular_momentum: return units::si::newton * units::si::meter * units::si::second;
    case q::center_of_mass: return units::si::meter;
    case q::generalized_momenta: return force(r.rows, row) * units::si::second;
    case q::configuration_residual:
    case q::configuration_terms: return residual(row);
    case q::redundant_residual:
    case q::redundant_terms: return redundant(row);
    case q::redundant_rate:
    case q::redundant_rate_terms: return redundant(row) / units::si::second;
    case q::redundant_bias: return redundant(row) / units::si::second / units::si::second;
    case q::redundant_jacobian: return redundant(row) / units::si::second / speed(r.columns, column);
    case q::configuration_jacobian_by_dependent:
      return residual(row) / chosen(0, s_.coordinates, column, true, coordinates);
    case q::configuration_jacobian_by_all: return residual(row) / state(by::coordinates, column);
    case q::configuration_step: return chosen(0, s_.coordinates, row, true, coordinates);
    case q::velocity_residual:
    case q::velocity_terms: return rate(row);
    case q::constraint_residual:
      if (row < s_.configuration_constraints) return residual(row);
      return rate(row - s_.configuration_constraints);
    case q::constraint_bias: return rate(row) / units::si::second;
    case q::constraint_jacobian: return rate(row) / speed(r.columns, column);
    case q::multipliers: return multiplier(row);
    case q::noncontributing_forces:
      return possible_unit(units::si::watt) /
             without_angle(table_.at(mechanics::unit_table::auxiliary_speeds, row));
    case q::dependent_speeds: return dependent_speed(row);
    case q::acceleration_bias: return dependent_speed(row) / units::si::second;
    case q::dependency: return dependent_speed(row) / speed(r.columns, column);
    case q::state_matrix:
    case q::state_jacobian: return state(r.rows, row) / units::si::second / state(r.columns, column);
    case q::input_matrix:
    case q::input_jacobian: return state(r.rows, row) / units::si::second / input(column);
    case q::regressor: return force(r.rows, row) / table_.inertial_parameter(column);
    case q::inertial_parameters: return table_.inertial_parameter(row);
    case q::mass_matrix_full: return of_all(row).entry / of_all(row).rate_at(*this, column);
    case q::forcing_full: return of_all(row).entry;
    case q::implicit_mass_matrix: return implicit(row).entry / implicit(row).rate_at(*this, column);
    case q::implicit_state_matrix: return implicit(row).entry / state(r.columns, column);
    case q::implicit_input_matrix: return implicit(row).entry / input(column);
    case q::constraint_pivots: // products of several units
    case q::weighted_gradient: // depend on the weights or the direction
    case q::directional_derivative:
    case q::weighted_hessian:
    case q::weighted_hessian_product: break;
    }
    return std::nullopt;
  }

  /// The unit of a row of the residual of the equations of motion, which has the order of the state: q̇, and M
  /// u̇ − f in the rows of the independent speeds and the constraints in those of the dependent ones.
  constexpr possible_unit of_residual(int row) const {
    if (!table_.is_stated) return std::nullopt;
    const int speed = row - s_.coordinates;
    if (speed < 0) return state(mechanics::extent_by::coordinates, row) / units::si::second;
    const int place = ordinal(s_.coordinates, speed);
    if (s_.dependent[row]) return acceleration(place);
    return force(mechanics::extent_by::independent_speeds, place);
  }

  /// The row or column of a symbol in a result; -1 if it has none.
  constexpr int place_of(mechanics::extent_by extent, symbolic::symbol_kind kind,
                         const base::name& called) const {
    using by = mechanics::extent_by;
    using symbolic::symbol_kind;
    if (extent == by::auxiliary_speeds) {
      for (int i = 0; i < table_.size(mechanics::unit_table::auxiliary_speeds); ++i)
        if (table_.names[table_.first[mechanics::unit_table::auxiliary_speeds] + i] == called) return i;
      return -1;
    }
    const int place = s_.place(kind, called);
    const bool is_coordinate = kind == symbol_kind::coordinate;
    const bool is_speed = kind == symbol_kind::speed || kind == symbol_kind::coordinate_rate;
    if (place < 0) return -1;
    switch (extent) {
    case by::coordinates: return is_coordinate ? place : -1;
    case by::speeds: return is_speed ? place : -1;
    case by::inputs: return kind == symbol_kind::input ? place : -1;
    case by::coordinates_and_speeds: return is_coordinate ? place : is_speed ? s_.coordinates + place : -1;
    case by::independent_speeds: return is_speed ? independent(s_.coordinates, place) : -1;
    case by::independent_states:
      if (is_coordinate) return independent(0, place);
      return is_speed ? s_.coordinates - s_.configuration_constraints + independent(s_.coordinates, place)
                      : -1;
    default: return -1;
    }
  }

private:
  /// The index of an independent symbol among the independent ones; -1 for a dependent one.
  constexpr int independent(int from, int place) const {
    return s_.dependent[from + place] ? -1 : ordinal(from, place);
  }
  /// The index of a symbol among those that are independent, or dependent, like it.
  constexpr int ordinal(int from, int place) const {
    int before = 0;
    for (int i = 0; i < place; ++i) before += s_.dependent[from + i] == s_.dependent[from + place] ? 1 : 0;
    return before;
  }

  /// A row of equations that are linear in the rates. A mass is in kg m² instead of kg m²/rad.
  struct row_units {
    possible_unit entry{};
    bool is_dynamic = false;

    constexpr possible_unit rate_at(const result_units& all, int column) const {
      const possible_unit rate = all.unknown(column);
      return is_dynamic ? without_angle(rate) : rate;
    }
  };
  /// A row of M_full [q̇; u̇] = f_full.
  constexpr row_units of_all(int row) const {
    if (row < s_.coordinates) return {table_.at(coordinates, row) / units::si::second};
    const int dynamic = row - s_.coordinates, independent = s_.speeds - s_.constraints;
    if (dynamic < independent) return {force(mechanics::extent_by::independent_speeds, dynamic), true};
    return {dependent_speed(dynamic - independent) / units::si::second};
  }
  /// A row of the implicit form: kinematic differential equations, rates of the constraints, dynamics.
  constexpr row_units implicit(int row) const {
    if (row < s_.coordinates) return {table_.at(mechanics::unit_table::kinematic_equations, row)};
    const int constraint = row - s_.coordinates, dynamic = constraint - s_.constraints;
    if (dynamic < 0) return {acceleration(constraint)};
    const bool is_full = s_.takes_rates_as_speeds;
    return {force(is_full ? mechanics::extent_by::speeds : mechanics::extent_by::independent_speeds, dynamic),
            true};
  }
  /// An entry of [q̇; u̇; λ].
  constexpr possible_unit unknown(int place) const {
    const int rates = s_.coordinates + s_.speeds;
    if (place < rates) return state(mechanics::extent_by::coordinates_and_speeds, place) / units::si::second;
    return multiplier(place - rates);
  }

  static constexpr auto coordinates = mechanics::unit_table::coordinates;
  static constexpr auto speeds = mechanics::unit_table::speeds;

  /// The generalized force of a speed; a torque is written N m, not N m/rad. That of a state variable is its
  /// rate.
  constexpr possible_unit force(mechanics::extent_by rows, int row) const {
    const bool is_rate = row >= s_.count(rows) - s_.state_variables; // of a state variable
    if (is_rate) return speed(rows, row) / units::si::second;
    return possible_unit(units::si::watt) / without_angle(speed(rows, row));
  }

  /// The unit of entry `place` among the dependent or independent symbols of a list.
  constexpr possible_unit chosen(int from, int size, int place, bool dependent,
                                 mechanics::unit_table::list of) const {
    for (int i = 0; i < size; ++i)
      if (s_.dependent[from + i] == dependent && place-- == 0) return table_.at(of, i);
    return std::nullopt;
  }
  constexpr possible_unit dependent_speed(int place) const {
    return chosen(s_.coordinates, s_.speeds, place, true, speeds);
  }
  constexpr possible_unit speed(mechanics::extent_by rows, int place) const {
    if (rows == mechanics::extent_by::speeds) return table_.at(speeds, place);
    return chosen(s_.coordinates, s_.speeds, place, false, speeds);
  }
  constexpr possible_unit state(mechanics::extent_by rows, int place) const {
    using by = mechanics::extent_by;
    if (rows == by::speeds) return table_.at(speeds, place);
    if (rows == by::independent_states) {
      const int independent = s_.coordinates - s_.configuration_constraints;
      if (place < independent) return chosen(0, s_.coordinates, place, false, coordinates);
      return speed(by::independent_speeds, place - independent);
    }
    if (place < s_.coordinates) return table_.at(coordinates, place);
    return table_.at(speeds, place - s_.coordinates);
  }
  constexpr possible_unit input(int place) const { return table_.at(mechanics::unit_table::inputs, place); }

  constexpr possible_unit residual(int place) const {
    return table_.at(mechanics::unit_table::configuration_constraints, place);
  }
  constexpr possible_unit redundant(int place) const {
    return table_.at(mechanics::unit_table::redundant_constraints, place);
  }
  /// The velocity that constraint `place` on the speeds keeps at zero.
  constexpr possible_unit rate(int place) const {
    const int given = table_.size(mechanics::unit_table::velocity_constraints);
    if (place < given) return table_.at(mechanics::unit_table::velocity_constraints, place);
    return residual(place - given) / units::si::second;
  }

  /// The rate of constraint `place` on the speeds, or the given constraint on accelerations.
  constexpr possible_unit acceleration(int place) const {
    if (table_.size(mechanics::unit_table::acceleration_constraints) != 0)
      return table_.at(mechanics::unit_table::acceleration_constraints, place);
    return rate(place) / units::si::second;
  }
  constexpr possible_unit multiplier(int constraint) const {
    return possible_unit(units::si::watt) / without_angle(rate(constraint));
  }

  const mechanics::unit_table& table_;
  const survey& s_;
};

} // namespace kanexpr::derivation
