#pragma once

#include <kanexpr/compiled/symbol_range.hpp>
#include <kanexpr/compiled/units_library.hpp>
#include <kanexpr/compiled/value_vector.hpp>
#include <kanexpr/quantities/given_quantity.hpp>
#include <kanexpr/units/unit.hpp>

#include <mp-units/systems/si.h>

namespace kanexpr {

namespace quantities {

/// A power of a unit of mp-units, with the exponent of a base unit in `of`.
template <units::unit of, units::base_unit base, class Unit>
constexpr auto mp_power(Unit known) {
  constexpr units::exponent power = of.exponent_of(base);
  if constexpr (power.numerator == 0)
    return mp_units::one;
  else if constexpr (power.numerator < 0)
    return mp_units::one / mp_units::pow<-power.numerator, power.denominator>(known);
  else
    return mp_units::pow<power.numerator, power.denominator>(known);
}

/// A coherent unit as a unit of mp-units.
template <units::unit of>
constexpr auto mp_unit() {
  using enum units::base_unit;
  namespace si = mp_units::si;
  return mp_power<of, kilogram>(si::kilogram) * mp_power<of, meter>(si::metre) *
         mp_power<of, second>(si::second) * mp_power<of, ampere>(si::ampere) *
         mp_power<of, kelvin>(si::kelvin) * mp_power<of, mole>(si::mole) *
         mp_power<of, candela>(si::candela) * mp_power<of, radian>(si::radian);
}

template <class Type>
inline constexpr bool is_of_mp_units = false;
template <auto reference, class Number>
inline constexpr bool is_of_mp_units<mp_units::quantity<reference, Number>> = true;

template <class Quantity>
concept of_mp_units = is_of_mp_units<Quantity>;

template <class Quantity, auto unit>
concept converts_to = requires(const Quantity& q) { (q * 1.0).numerical_value_in(unit); };

} // namespace quantities

/// mp-units itself determines which quantities convert to a unit, for example an angle in degrees to rad and
/// to 1.
template <quantities::of_mp_units Quantity>
struct compiled::units_library<Quantity> {
  template <units::unit in>
  static constexpr bool converts = quantities::converts_to<Quantity, quantities::mp_unit<in>()>;
  template <units::unit in>
  static constexpr double number(const Quantity& q) {
    return (q * 1.0).numerical_value_in(quantities::mp_unit<in>());
  }
};

/// Returns a number in a coherent unit as a quantity of mp-units: `mp_quantity<newton*meter>(2)`.
template <units::unit in>
constexpr auto mp_quantity(double number) {
  return number * quantities::mp_unit<in>();
}

/// Returns an entry of a state, of parameters or of inputs as a quantity of mp-units: `mp_quantity(x, q1)`.
/// The symbol states its unit.
template <class System, compiled::symbols_of which, class Scalar, class Symbol>
constexpr auto mp_quantity(const compiled::value_vector<System, which, Scalar>& values,
                           const Symbol& symbol) {
  using symbol_of_system = quantities::unit_of_symbol<System, Symbol>;
  if constexpr (symbol_of_system::is_known)
    return mp_quantity<*symbol_of_system::found>(static_cast<double>(values[symbol]));
}

} // namespace kanexpr
