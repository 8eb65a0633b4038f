#pragma once

#include <kanexpr/compiled/symbol_range.hpp>
#include <kanexpr/compiled/units_library.hpp>
#include <kanexpr/compiled/value_vector.hpp>
#include <kanexpr/quantities/given_quantity.hpp>
#include <kanexpr/units/si.hpp>
#include <kanexpr/units/unit.hpp>

#include <boost/units/pow.hpp>
#include <boost/units/quantity.hpp>
#include <boost/units/static_rational.hpp>
#include <boost/units/systems/si.hpp>

namespace kanexpr {

namespace quantities {

/// The base unit of a dimension of Boost.Units. Dimensions outside the SI, such as information, have none.
template <class Dimension>
struct base_of;
template <>
struct base_of<boost::units::mass_base_dimension> {
  static constexpr units::unit unit = units::si::kilogram;
};
template <>
struct base_of<boost::units::length_base_dimension> {
  static constexpr units::unit unit = units::si::meter;
};
template <>
struct base_of<boost::units::time_base_dimension> {
  static constexpr units::unit unit = units::si::second;
};
template <>
struct base_of<boost::units::current_base_dimension> {
  static constexpr units::unit unit = units::si::ampere;
};
template <>
struct base_of<boost::units::temperature_base_dimension> {
  static constexpr units::unit unit = units::si::kelvin;
};
template <>
struct base_of<boost::units::amount_base_dimension> {
  static constexpr units::unit unit = units::si::mole;
};
template <>
struct base_of<boost::units::luminous_intensity_base_dimension> {
  static constexpr units::unit unit = units::si::candela;
};
template <>
struct base_of<boost::units::plane_angle_base_dimension> {
  static constexpr units::unit unit = units::si::radian;
};

/// The coherent unit of a list of dimensions.
template <class Dimensions>
struct coherent;
template <>
struct coherent<boost::units::dimensionless_type> {
  static constexpr units::unit unit = units::dimensionless;
};
template <class Base, boost::units::integer_type numerator, boost::units::integer_type denominator,
          class Rest>
  requires requires { base_of<Base>::unit, coherent<Rest>::unit; }
struct coherent<boost::units::list<
    boost::units::dim<Base, boost::units::static_rational<numerator, denominator>>, Rest>> {
  static constexpr units::unit unit =
      units::power(base_of<Base>::unit, numerator, denominator) * coherent<Rest>::unit;
};

/// A power of a unit of Boost.Units, with the exponent of a base unit in `of`.
template <units::unit of, units::base_unit base, class Unit>
constexpr auto boost_power(Unit known) {
  constexpr units::exponent power = of.exponent_of(base);
  if constexpr (power.numerator == 0)
    return boost::units::si::dimensionless();
  else
    return boost::units::pow<boost::units::static_rational<power.numerator, power.denominator>>(known);
}

/// A coherent unit as a unit of Boost.Units.
template <units::unit of>
constexpr auto boost_unit() {
  using enum units::base_unit;
  namespace si = boost::units::si;
  return boost_power<of, kilogram>(si::mass()) * boost_power<of, meter>(si::length()) *
         boost_power<of, second>(si::time()) * boost_power<of, ampere>(si::current()) *
         boost_power<of, kelvin>(si::temperature()) * boost_power<of, mole>(si::amount()) *
         boost_power<of, candela>(si::luminous_intensity()) * boost_power<of, radian>(si::plane_angle());
}

} // namespace quantities

/// Boost.Units has an angle among its dimensions, which a torque contains, for example: it does not matter.
template <class Dimensions, class System, class Number>
struct compiled::units_library<boost::units::quantity<boost::units::unit<Dimensions, System>, Number>> {
  using quantity = boost::units::quantity<boost::units::unit<Dimensions, System>, Number>;
  using coherent_quantity =
      boost::units::quantity<boost::units::unit<Dimensions, boost::units::si::system>, double>;

  template <units::unit in>
  static constexpr bool converts = [] {
    if constexpr (requires { quantities::coherent<Dimensions>::unit; })
      return units::fits(in, quantities::coherent<Dimensions>::unit);
    else
      return false;
  }();
  template <units::unit>
  static constexpr double number(const quantity& q) {
    return static_cast<coherent_quantity>(q).value();
  }
};

/// Returns a number in a coherent unit as a quantity of Boost.Units: `boost_quantity<newton*meter>(2)`.
template <units::unit in>
constexpr auto boost_quantity(double number) {
  return number * quantities::boost_unit<in>();
}

/// Returns an entry of a state, of parameters or of inputs as a quantity of Boost.Units: `boost_quantity(x,
/// q1)`. The symbol states its unit.
template <class System, compiled::symbols_of which, class Scalar, class Symbol>
constexpr auto boost_quantity(const compiled::value_vector<System, which, Scalar>& values,
                              const Symbol& symbol) {
  using symbol_of_system = quantities::unit_of_symbol<System, Symbol>;
  if constexpr (symbol_of_system::is_known)
    return boost_quantity<*symbol_of_system::found>(static_cast<double>(values[symbol]));
}

} // namespace kanexpr
