#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/compiled/units_library.hpp>
#include <kanexpr/derivation/model_error.hpp>
#include <kanexpr/units/unit_text.hpp>

namespace kanexpr {

namespace quantities {

/// Reports a symbol without a unit.
template <class Named>
struct known_unit {
  static constexpr bool is_known = Named::unit != nullptr;
  static constexpr base::sentence mistake = [] {
    if (is_known) return base::sentence{};
    return base::sentence({Named::called(), " states no unit, so its value is a number, not a quantity"});
  }();
  static_assert(derivation::report<known_unit>());
};

/// Reports a quantity that does not convert to the unit of its symbol.
template <class Named, class Quantity>
struct given_quantity {
  static constexpr bool converts = [] {
    if constexpr (known_unit<Named>::is_known)
      return compiled::units_library<Quantity>::template converts<*Named::unit>;
    else
      return false;
  }();
  static constexpr base::sentence mistake = [] {
    if constexpr (converts || Named::unit == nullptr)
      return base::sentence{};
    else
      return base::sentence({"the quantity given for ", Named::called(), " does not convert to its unit, ",
                             units::text_of(*Named::unit).view()});
  }();
  static_assert(derivation::report<given_quantity>());
};

} // namespace quantities

template <class Named, class Quantity>
constexpr double compiled::number_of(const Quantity& given) {
  if constexpr (quantities::given_quantity<Named, Quantity>::converts)
    return compiled::units_library<Quantity>::template number<*Named::unit>(given);
  else
    return 0;
}

} // namespace kanexpr
