#pragma once

#include <kanexpr/base/name.hpp>
#include <kanexpr/mechanics/units/unit_inference.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/units/possible_unit.hpp>
#include <kanexpr/units/si.hpp>
#include <kanexpr/units/unit.hpp>
#include <kanexpr/units/unit_text.hpp>

#include <optional>
#include <string_view>

namespace kanexpr::mechanics {

using units::possible_unit;

/// The units of the symbols and equations of a system, in order.
struct unit_table {
  static constexpr int room = 512;

  /// The lists of the table, one after the other.
  enum list : unsigned char {
    coordinates,
    speeds,
    parameters,
    inputs,
    auxiliary_speeds,
    configuration_constraints,
    redundant_constraints,
    velocity_constraints,
    acceleration_constraints,
    kinematic_equations,
    lists
  };

  bool is_stated = false; ///< whether any unit is stated or implied
  int first[lists + 1]{}; ///< where each list begins
  base::name names[room]{};
  units::unit known[room]{};
  bool is_known[room]{};
  int bodies = 0;           ///< bodies beyond the room are not listed
  bool is_particle[room]{}; ///< whether the body has no inertial parameter except its mass

  constexpr int size(list of) const { return first[of + 1] - first[of]; }
  constexpr possible_unit at(list of, int place) const {
    const int i = first[of] + place;
    if (place < 0 || place >= size(of) || !is_known[i]) return std::nullopt;
    return known[i];
  }
  /// The unit of a symbol by its name; nothing if there is no such symbol.
  constexpr possible_unit of(std::string_view called) const {
    for (int i = 0; i < first[configuration_constraints]; ++i)
      if (names[i].view() == called && is_known[i]) return known[i];
    return std::nullopt;
  }
  /// The unit of an inertial parameter: a mass, a first moment or an inertia.
  constexpr possible_unit inertial_parameter(int place) const {
    constexpr units::unit kilogram = units::si::kilogram, meter = units::si::meter;
    for (int i = 0; i < bodies && place >= 0; ++i) {
      const int size = is_particle[i] ? 1 : 10;
      if (place < size)
        return place == 0 ? kilogram : place < 4 ? kilogram * meter : kilogram * meter * meter;
      place -= size;
    }
    return std::nullopt;
  }
  /// The number of symbols whose units are listed.
  constexpr int symbols() const { return first[configuration_constraints]; }

  /// Lists the inertial parameters of a body.
  constexpr void put_body(bool is_a_particle) {
    if (bodies < room) is_particle[bodies++] = is_a_particle;
  }
  /// Begins a list; lists must be filled in order.
  constexpr void begin(list to) { first[to + 1] = first[to]; }
  /// Appends the unit of an expression to a list; it is omitted if the table is full.
  constexpr void put(list to, expression e, unit_inference& inferred) {
    const int i = first[to + 1];
    if (i == room) return;
    ++first[to + 1];
    if (e.owner()[e.node()].op == symbolic::operation::symbol)
      names[i] = e.owner().symbol_at(e.node()).called;
    const possible_unit u = inferred.unit_of(e);
    is_known[i] = u.has_value();
    if (u.has_value()) known[i] = *u;
  }
};

/// Prints the symbols with their units, one a line: `q1 [rad]`.
template <class Stream>
auto operator<<(Stream& to, const unit_table& table) -> decltype(to << table.names[0].view()) {
  for (int i = 0; i < table.symbols(); ++i)
    to << table.names[i].view() << " ["
       << units::text_of(table.is_known[i] ? possible_unit(table.known[i]) : possible_unit()).view() << "]\n";
  return to;
}

} // namespace kanexpr::mechanics
