#pragma once

/// Values that are given as quantities of a units library: `{m, 2 * kg}`.
namespace kanexpr::compiled {

/// Specialized for the quantities of a library: `converts<in>` is whether a quantity converts to a coherent
/// unit, and `number<in>` returns it in this unit. See <kanexpr/mp_units.hpp>.
template <class Quantity>
struct units_library;

template <class Value>
concept quantity_of_a_library = requires { sizeof(units_library<Value>); };

/// Returns a quantity as a number in the unit of a symbol, which the symbol states or which follows from
/// those that the system states; `System` is void if it is unknown. See quantities/given_quantity.hpp.
template <class System, class Symbol, class Quantity>
constexpr double number_of(const Quantity& given);

} // namespace kanexpr::compiled
