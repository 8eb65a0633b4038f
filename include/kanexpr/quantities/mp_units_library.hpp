#pragma once

#include <kanexpr/compiled/symbol_range.hpp>
#include <kanexpr/compiled/units_library.hpp>
#include <kanexpr/compiled/value_vector.hpp>
#include <kanexpr/quantities/returned_quantity.hpp>
#include <kanexpr/units/unit.hpp>

#include <mp-units/systems/si.h>

#include <tuple>

namespace kanexpr {

namespace quantities {

/// The units of mp-units.
struct mp_units_library {
  static constexpr std::tuple base_units{mp_units::si::kilogram, mp_units::si::metre,  mp_units::si::second,
                                         mp_units::si::ampere,   mp_units::si::kelvin, mp_units::si::mole,
                                         mp_units::si::candela,  mp_units::si::radian};
  static constexpr auto one = mp_units::one;

  template <int numerator, int denominator, class Unit>
  static constexpr auto power(Unit known) {
    if constexpr (numerator < 0)
      return mp_units::one / mp_units::pow<-numerator, denominator>(known);
    else
      return mp_units::pow<numerator, denominator>(known);
  }
};

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
  static constexpr bool converts =
      quantities::converts_to<Quantity, quantities::unit_in<quantities::mp_units_library, in>()>;
  template <units::unit in>
  static constexpr double number(const Quantity& q) {
    return (q * 1.0).numerical_value_in(quantities::unit_in<quantities::mp_units_library, in>());
  }
};

/// Returns a number in a coherent unit as a quantity of mp-units: `mp_quantity<newton*meter>(2)`.
template <units::unit in>
constexpr auto mp_quantity(double number) {
  return number * quantities::unit_in<quantities::mp_units_library, in>();
}

/// Returns an entry of a state, of parameters or of inputs as a quantity of mp-units: `mp_quantity(x, q1)`.
/// The symbol states its unit.
template <class System, compiled::symbols_of which, class Scalar, class Symbol>
constexpr auto mp_quantity(const compiled::value_vector<System, which, Scalar>& values,
                           const Symbol& symbol) {
  return quantities::returned_quantity<quantities::mp_units_library>(values, symbol);
}

} // namespace kanexpr
