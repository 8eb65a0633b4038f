#pragma once

#include <kanexpr/compiled/symbol_range.hpp>
#include <kanexpr/compiled/value_vector.hpp>
#include <kanexpr/quantities/given_quantity.hpp>
#include <kanexpr/units/unit.hpp>

#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

/// Numbers as quantities of a units library. The library is described by a type with
///
///   base_units              a tuple of its base units, in the order of `units::base_unit`,
///   one                     its unit of a number,
///   power<n, d>(unit)       a unit to the power n/d, which is not zero.
namespace kanexpr::quantities {

template <class Library, units::unit of, std::size_t base>
constexpr auto power_of_base() {
  constexpr units::exponent power = of.exponent_of(units::base_unit_at(static_cast<int>(base)));
  if constexpr (power.numerator == 0)
    return Library::one;
  else
    return Library::template power<power.numerator, power.denominator>(std::get<base>(Library::base_units));
}

/// A coherent unit as a unit of the library.
template <class Library, units::unit of>
constexpr auto unit_in() {
  static_assert(std::tuple_size_v<std::remove_cvref_t<decltype(Library::base_units)>> == units::base_units);
  return []<std::size_t... base>(std::index_sequence<base...>) {
    return (power_of_base<Library, of, base>() * ...);
  }(std::make_index_sequence<units::base_units>());
}

/// An entry of a state, of parameters or of inputs as a quantity of the library. The unit of the symbol must
/// be known.
template <class Library, class System, compiled::symbols_of which, class Scalar, class Symbol>
constexpr auto returned_quantity(const compiled::value_vector<System, which, Scalar>& values,
                                 const Symbol& symbol) {
  using symbol_of_system = unit_of_symbol<System, Symbol>;
  if constexpr (symbol_of_system::is_known)
    return static_cast<double>(values[symbol]) * unit_in<Library, *symbol_of_system::found>();
}

} // namespace kanexpr::quantities
