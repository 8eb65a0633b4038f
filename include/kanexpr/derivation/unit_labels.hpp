#pragma once

#include <kanexpr/derivation/result_units.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/mechanics/units/unit_table.hpp>
#include <kanexpr/units/unit_text.hpp>

#include <string>
#include <string_view>

/// Units as labels of columns, arguments and results. A unit that is not determined has no label.
namespace kanexpr::derivation {

inline std::string unit_label(const possible_unit& u, units::spelling how = units::spelling::printed) {
  return u ? std::string(units::text_of(*u, how).view()) : std::string();
}

/// The label of a symbol, by its index in the names of a survey; `symbols` is null if the model states no
/// units. Only parameters have to be found by name, because those that are bound to numbers have a unit, too.
inline std::string unit_label(const mechanics::unit_table* symbols, const survey& known, int place,
                              units::spelling how = units::spelling::printed) {
  using table = mechanics::unit_table;
  if (symbols == nullptr) return {};
  const int speed = known.coordinates, parameter = speed + known.speeds, input = parameter + known.parameters;
  if (place < speed) return unit_label(symbols->at(table::coordinates, place), how);
  if (place < parameter) return unit_label(symbols->at(table::speeds, place - speed), how);
  if (place < input) return unit_label(symbols->of(known.names[place].view()), how);
  return unit_label(symbols->at(table::inputs, place - input), how);
}

/// Whether a result is an energy. Its unit is written J, although a torque of the same unit is written N m.
constexpr bool is_energy(mechanics::quantity of) {
  return of == mechanics::quantity::kinetic_energy || of == mechanics::quantity::potential_energy;
}

} // namespace kanexpr::derivation
