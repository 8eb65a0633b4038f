#pragma once

/// Values that are given as quantities of a units library: `{m, 2 * kg}`.
namespace kanexpr::compiled {

/// Specialized for the quantities of a library: `converts<in>` is whether a quantity converts to a coherent
/// unit, and `number<in>` returns it in this unit. See <kanexpr/mp_units.hpp>.
template <class Quantity>
struct units_library;

template <class Value>
concept quantity_of_a_library = requires { sizeof(units_library<Value>); };

/// Returns a quantity as a number in the unit of a symbol. `Named` has the name of the symbol and the address
/// of its unit, which is null if it is unknown. See quantities/given_quantity.hpp.
template <class Named, class Quantity>
constexpr double number_of(const Quantity& given);

/// The unit that a symbol states.
template <class Symbol>
struct stated_by {
  static constexpr Symbol symbol{};
  static constexpr auto called() { return symbol.tokens[0].symbol->called.view(); }
  static constexpr auto* unit = symbol.tokens[0].symbol->unit;
};

} // namespace kanexpr::compiled
