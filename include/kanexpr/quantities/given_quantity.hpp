#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/compiled/units_library.hpp>
#include <kanexpr/compiled/units_of.hpp>
#include <kanexpr/derivation/model_error.hpp>
#include <kanexpr/mechanics/units/unit_table.hpp>
#include <kanexpr/units/unit_text.hpp>

#include <string_view>
#include <type_traits>

namespace kanexpr {

namespace quantities {

/// The unit of a symbol, which the symbol states or which follows from those that the system states. `System`
/// is void if it is unknown. Reports a symbol without a unit.
template <class System, class Symbol>
struct unit_of_symbol {
  static constexpr Symbol symbol{};
  static constexpr std::string_view called() { return symbol.tokens[0].symbol->called.view(); }

  static constexpr mechanics::possible_unit found = [] {
    if (symbol.tokens[0].symbol->unit != nullptr)
      return mechanics::possible_unit(*symbol.tokens[0].symbol->unit);
    if constexpr (!std::is_void_v<System>)
      if (const mechanics::unit_table* all = compiled::stated_units_of<System>(); all != nullptr)
        return all->of(called());
    return mechanics::possible_unit();
  }();
  static constexpr bool is_known = found.has_value();

  static constexpr base::sentence mistake = [] {
    if (is_known) return base::sentence{};
    if (std::is_void_v<System>)
      return base::sentence({called(), " states no unit, so its value is a number, not a quantity"});
    return base::sentence(
        {"the unit of ", called(), " is not determined, so its value is a number, not a quantity"});
  }();
  static_assert(derivation::report<unit_of_symbol>());
};

/// Reports a quantity that does not convert to the unit of its symbol.
template <class System, class Symbol, class Quantity>
struct given_quantity {
  using symbol = unit_of_symbol<System, Symbol>;

  static constexpr bool converts = [] {
    if constexpr (symbol::is_known)
      return compiled::units_library<Quantity>::template converts<*symbol::found>;
    else
      return false;
  }();
  static constexpr base::sentence mistake = [] {
    if (converts || !symbol::is_known) return base::sentence{};
    return base::sentence({"the quantity given for ", symbol::called(), " does not convert to its unit, ",
                           units::text_of(symbol::found, units::spelling::message).view()});
  }();
  static_assert(derivation::report<given_quantity>());
};

} // namespace quantities

template <class System, class Symbol, class Quantity>
constexpr double compiled::number_of(const Quantity& given) {
  using checked = quantities::given_quantity<System, Symbol, Quantity>;
  if constexpr (checked::converts)
    return compiled::units_library<Quantity>::template number<*checked::symbol::found>(given);
  else
    return 0;
}

} // namespace kanexpr
