#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/derivation/model_error.hpp>
#include <kanexpr/units/unit.hpp>
#include <kanexpr/units/unit_text.hpp>

#include <optional>
#include <string_view>

/// Values that are given as quantities of a units library, such as mp-units.
namespace kanexpr::compiled {

/// Specialized for the quantities of a units library: `converts<in>` is whether a quantity converts to a
/// coherent unit, and `number<in>` returns it in this unit. See <kanexpr/mp_units.hpp>.
template <class Quantity>
struct units_library;

template <class Value>
concept quantity_of_a_library = requires { sizeof(units_library<Value>); };

/// Reports a quantity that does not convert to the unit of its symbol, or a symbol without a unit. `Named` has
/// the name of the symbol, `called`, and its unit, `unit`, if it is known.
template <class Named, class Quantity>
struct quantity_check {
  static constexpr bool converts = [] {
    if constexpr (Named::unit.has_value())
      return units_library<Quantity>::template converts<*Named::unit>;
    else
      return false;
  }();
  static constexpr base::sentence mistake = [] {
    if (converts) return base::sentence{};
    if (!Named::unit) return base::sentence({"the unit of ", Named::called(), " is unknown; give its value as a number"});
    return base::sentence({"the quantity given for ", Named::called(), " does not convert to its unit, ",
                           units::text_of(*Named::unit).view()});
  }();
  static_assert(derivation::report<quantity_check>());
};

/// Returns a quantity as a number in the unit of a symbol.
template <class Named, class Quantity>
constexpr double number_of(const Quantity& q) {
  if constexpr (quantity_check<Named, Quantity>::converts)
    return units_library<Quantity>::template number<*Named::unit>(q);
  else
    return 0;
}

} // namespace kanexpr::compiled
