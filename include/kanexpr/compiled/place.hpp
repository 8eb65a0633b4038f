#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/compiled/symbol_range.hpp>
#include <kanexpr/compiled/units_library.hpp>
#include <kanexpr/derivation/model_error.hpp>
#include <kanexpr/derivation/read/wording.hpp>
#include <kanexpr/describe/symbol.hpp>
#include <kanexpr/lower/scalar_math.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <concepts>
#include <string_view>

/// Symbols and names in vectors of values: their indices, and entries of lists.
namespace kanexpr::compiled {

/// The index of a symbol in a vector in which symbols of its kind start at `first`.
template <class System, symbolic::symbol_kind kind, text called, int index, int first = 0,
          int order = describe::unprescribed>
struct placed {
  static constexpr const describe::symbol_record& symbol =
      describe::symbol_storage<kind, called, index, order>::record;
  static constexpr int found = survey_of<System>.place(kind, symbol.called);
  static constexpr int place = first + (found >= 0 ? found : 0);
  static constexpr base::sentence mistake = [] {
    if (found >= 0 || survey_of<System>.mistake) return base::sentence{};
    if (kind == symbolic::symbol_kind::coordinate_rate)
      return base::sentence({"the state of ", type_name<System>(),
                             " does not contain the rate of coordinate ", symbol.called.view()});
    const std::string_view what = derivation::kind_of(symbol);
    return base::sentence({"the system ", type_name<System>(), " has no ", what, symbol.called.view()});
  }();
  static_assert(derivation::report<placed>());
};

/// The index of a symbol in a vector of a system. A symbol of a kind that the vector does not contain, such
/// as a parameter looked up in the state, causes a compile-time error.
template <class System, symbols_of which, class Symbol>
struct place_in {
  static constexpr Symbol asked{};
  static constexpr base::sentence mistake = [] {
    if (survey_of<System>.mistake) return base::sentence{};
    const describe::symbol_record* s = asked.tokens[0].symbol;
    return base::sentence({s != nullptr ? s->called.view() : "the expression", " is not an entry of the ",
                           range_of(which, survey_of<System>).vector, " vector of ", type_name<System>()});
  }();
  static_assert(derivation::report<place_in>());
  static constexpr int place = 0;
};

/// A symbol that states its unit has the place of the same symbol without one.
template <class System, symbols_of which, class Symbol>
  requires requires { typename Symbol::without_unit; }
struct place_in<System, which, Symbol> : place_in<System, which, typename Symbol::without_unit> {};

template <class System, text called, int index>
struct place_in<System, symbols_of::state, describe::symbol<symbolic::symbol_kind::coordinate, called, index>>
    : placed<System, symbolic::symbol_kind::coordinate, called, index> {};

template <class System, text called, int index>
struct place_in<System, symbols_of::state, describe::symbol<symbolic::symbol_kind::speed, called, index>>
    : placed<System, symbolic::symbol_kind::speed, called, index, survey_of<System>.coordinates> {};

template <class System, text called, int index>
struct place_in<System, symbols_of::state,
                describe::symbol<symbolic::symbol_kind::speed, called, index, describe::of_state_variable>>
    : placed<System, symbolic::symbol_kind::speed, called, index, survey_of<System>.coordinates,
             describe::of_state_variable> {};

/// With Lagrange's method, the rates of the coordinates are in the state: `x[dot(q1)]`.
template <class System, text called, int index>
struct place_in<System, symbols_of::state, coordinate_rate<called, index>>
    : placed<System, symbolic::symbol_kind::coordinate_rate, called, index, survey_of<System>.coordinates> {};

template <class System, text called, int index>
struct place_in<System, symbols_of::parameters,
                describe::symbol<symbolic::symbol_kind::parameter, called, index>>
    : placed<System, symbolic::symbol_kind::parameter, called, index> {};

template <class System, text called, int index>
struct place_in<System, symbols_of::inputs, describe::symbol<symbolic::symbol_kind::input, called, index>>
    : placed<System, symbolic::symbol_kind::input, called, index> {};

/// The index of a prescribed quantity or of its derivatives: `r[theta]`, `r[dot(theta)]`.
template <class System, text called, int index, int order>
struct place_in<System, symbols_of::inputs,
                describe::symbol<symbolic::symbol_kind::input, called, index, order>>
    : placed<System, symbolic::symbol_kind::input, called, index, 0, order> {};

/// The value of an entry in a vector of a system, with the symbol or its name: `{q1, 0.1}`, `{"m", 2.5}`. A
/// symbol is looked up at compile time, a name at run time. With a symbol, the value may be a quantity of a
/// units library: `{m, 2 * kg}`.
template <class System, symbols_of which, class Scalar>
struct entry {
  int place; ///< the index in the vector; negative if none of its symbols has the name
  Scalar value;
  std::string_view name{}; ///< set if the entry was specified by name

  template <class Symbol, class Value>
    requires requires(const Symbol& symbol) { describe::shape_of(symbol); }
  constexpr entry(const Symbol&, const Value& number)
      : place(place_in<System, which, Symbol>::place), value(taken<Symbol>(number)) {}

  template <std::convertible_to<std::string_view> Name, class Value>
  constexpr entry(const Name& called, const Value& number)
      : place(place_called(called)), value(taken(number)), name(called) {}

private:
  template <class Symbol = void, class Value>
  static constexpr Scalar taken(const Value& number) {
    if constexpr (quantity_of_a_library<Value>)
      return lower::scalar_math<Scalar>::from(number_of<System, Symbol>(number));
    else if constexpr (std::convertible_to<Value, Scalar>)
      return static_cast<Scalar>(number);
    else
      return lower::scalar_math<Scalar>::from(static_cast<double>(number));
  }
  static constexpr int place_called(std::string_view name) {
    constexpr symbol_range range = range_of(which, survey_of<System>);
    for (int i = 0; i < range.size; ++i)
      if (survey_of<System>.names[range.first + i].view() == name) return i;
    return -1;
  }
};

} // namespace kanexpr::compiled
