#pragma once

#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/derivation/model_units.hpp>
#include <kanexpr/derivation/result_units.hpp>
#include <kanexpr/derivation/stages.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/describe/operand.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/mechanics/units/unit_table.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <optional>

namespace kanexpr {

namespace compiled {

/// The units of the symbols and equations of a system, inferred once. Units that are only implied are not
/// inferred, so the model need not be read again.
template <class System>
inline constexpr mechanics::unit_table unit_table_of = [] {
  if constexpr (requires { surveyed<System>::is_linked; } || !survey_of<System>.states_units ||
                survey_of<System>.checks_units) {
    return derivation::unit_table_of(System::record);
  } else {
    const derivation::derived_system system(System::record,
                                            derivation::stages_of<System>::constrained.stored);
    return mechanics::unit_table_of(system.system());
  }
}();

/// The address of this table; null if the model states no units, which are then not inferred.
template <class System>
constexpr const mechanics::unit_table* stated_units_of() {
  if constexpr (survey_of<System>.states_units && !survey_of<System>.mistake)
    return &unit_table_of<System>;
  else
    return nullptr;
}

/// The unit of an entry of a result, by its row and column.
template <class System>
constexpr mechanics::possible_unit unit_of(mechanics::quantity wanted, int row = 0, int column = 0) {
  return derivation::result_units(unit_table_of<System>, survey_of<System>).of(wanted, row, column);
}

/// The row or column of a symbol in a result; -1 if it has none.
template <class System>
constexpr int place_of(mechanics::extent_by extent, const scalar<1>& symbol) {
  const describe::symbol_record* const s = symbol.tokens[0].symbol;
  if (s == nullptr) return -1;
  return derivation::result_units(unit_table_of<System>, survey_of<System>)
      .place_of(extent, s->kind, s->called);
}

} // namespace compiled

/// The units of all symbols of a system, those that the model states and those that follow from them.
/// Printed, the table names those that are not determined.
template <class System>
constexpr const mechanics::unit_table& units_of() {
  static_cast<void>(compiled::survey_of<System>); // reports a mistake in the system
  return compiled::unit_table_of<System>;
}

/// The unit of an expression of a model; for a vector, of its components:
/// `units_of<System>(magnitude(velocity_of<P>))`.
template <class System, describe::shape kind, int size>
constexpr mechanics::possible_unit units_of(const postfix_expression<kind, size>& e) {
  static_cast<void>(compiled::survey_of<System>);
  return derivation::unit_of(System::record, {kind, e.tokens, size});
}

/// The unit of a scalar result: `units_of(eom::kinetic_energy)`.
template <template <class, auto...> class Result, class System, mechanics::quantity wanted>
constexpr mechanics::possible_unit units_of(const Result<System, wanted>&) {
  return compiled::unit_of<System>(wanted);
}

/// The unit of the entry of a result in the row of a symbol: `units_of(eom::udot, u1)`. Nothing if the result
/// has no such row, or the unit is not determined.
template <template <class, auto...> class Result, class System, mechanics::quantity wanted>
constexpr mechanics::possible_unit units_of(const Result<System, wanted>&, const scalar<1>& row) {
  const int place = compiled::place_of<System>(mechanics::row_of(wanted).rows, row);
  if (place < 0) return std::nullopt;
  return compiled::unit_of<System>(wanted, place);
}

/// The unit of the entry of a matrix in the row and the column of two symbols: `units_of(eom::mass_matrix,
/// u1, u2)`.
template <template <class, auto...> class Result, class System, mechanics::quantity wanted>
constexpr mechanics::possible_unit units_of(const Result<System, wanted>&, const scalar<1>& row,
                                            const scalar<1>& column) {
  const int i = compiled::place_of<System>(mechanics::row_of(wanted).rows, row);
  const int j = compiled::place_of<System>(mechanics::row_of(wanted).columns, column);
  if (i < 0 || j < 0) return std::nullopt;
  return compiled::unit_of<System>(wanted, i, j);
}

/// The unit of the entry of a result by its row and column, counted from 0, for rows and columns that belong
/// to no symbol: `units_of(regressor<System>::matrix, 1, 10)`.
template <template <class, auto...> class Result, class System, mechanics::quantity wanted>
constexpr mechanics::possible_unit units_of(const Result<System, wanted>&, int row, int column = 0) {
  return compiled::unit_of<System>(wanted, row, column);
}

} // namespace kanexpr
