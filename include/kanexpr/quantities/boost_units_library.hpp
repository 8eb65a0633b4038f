#pragma once

#include <kanexpr/compiled/symbol_range.hpp>
#include <kanexpr/compiled/units_library.hpp>
#include <kanexpr/compiled/value_vector.hpp>
#include <kanexpr/quantities/returned_quantity.hpp>
#include <kanexpr/units/unit.hpp>

#include <boost/units/pow.hpp>
#include <boost/units/quantity.hpp>
#include <boost/units/static_rational.hpp>
#include <boost/units/systems/si.hpp>
#include <boost/units/unit.hpp>

#include <cstddef>
#include <tuple>
#include <type_traits>

namespace kanexpr {

namespace quantities {

/// The base dimensions of the SI in Boost.Units, in the order of `units::base_unit`.
template <class... Dimensions>
struct base_dimensions {
  /// The place of a dimension; their number for dimensions outside the SI, such as information.
  template <class Dimension>
  static constexpr std::size_t place_of = [] {
    std::size_t place = 0;
    static_cast<void>(((!std::is_same_v<Dimension, Dimensions> && ++place) && ...));
    return place;
  }();
  static constexpr std::tuple units{
      boost::units::unit<typename Dimensions::dimension_type, boost::units::si::system>()...};
};
using base_dimensions_of_si =
    base_dimensions<boost::units::mass_base_dimension, boost::units::length_base_dimension,
                    boost::units::time_base_dimension, boost::units::current_base_dimension,
                    boost::units::temperature_base_dimension, boost::units::amount_base_dimension,
                    boost::units::luminous_intensity_base_dimension,
                    boost::units::plane_angle_base_dimension>;

/// The units of Boost.Units.
struct boost_units_library {
  static constexpr auto base_units = base_dimensions_of_si::units;
  static constexpr boost::units::si::dimensionless one{};

  template <int numerator, int denominator, class Unit>
  static constexpr auto power(Unit known) {
    return boost::units::pow<boost::units::static_rational<numerator, denominator>>(known);
  }
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
  requires(base_dimensions_of_si::place_of<Base> < units::base_units) && requires { coherent<Rest>::unit; }
struct coherent<boost::units::list<
    boost::units::dim<Base, boost::units::static_rational<numerator, denominator>>, Rest>> {
  static constexpr units::unit unit =
      units::power(units::only(units::base_unit_at(static_cast<int>(base_dimensions_of_si::place_of<Base>))),
                   numerator, denominator) *
      coherent<Rest>::unit;
};

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
  return number * quantities::unit_in<quantities::boost_units_library, in>();
}

/// Returns an entry of a state, of parameters or of inputs as a quantity of Boost.Units: `boost_quantity(x,
/// q1)`. The symbol states its unit.
template <class System, compiled::symbols_of which, class Scalar, class Symbol>
constexpr auto boost_quantity(const compiled::value_vector<System, which, Scalar>& values,
                              const Symbol& symbol) {
  return quantities::returned_quantity<quantities::boost_units_library>(values, symbol);
}

} // namespace kanexpr
