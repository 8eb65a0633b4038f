#pragma once

#include <kanexpr/compiled/place.hpp>
#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/lower/scalar_math.hpp>

#include <concepts>
#include <string_view>

namespace kanexpr::compiled {

/// The value of an entry in a vector of a system, with the symbol or its name: `{q1, 0.1}`, `{"m", 2.5}`. A
/// symbol is looked up at compile time, a name at run time.
template <class System, symbols_of which, class Scalar>
struct entry {
  int place; ///< the index in the vector; negative if none of its symbols has the name
  Scalar value;
  std::string_view name{}; ///< set if the entry was specified by name

  template <class Symbol, class Value>
    requires requires(const Symbol& symbol) { describe::shape_of(symbol); }
  constexpr entry(const Symbol&, const Value& number)
      : place(place_in<System, which, Symbol>::place), value(taken(number)) {}

  template <std::convertible_to<std::string_view> Name, class Value>
  constexpr entry(const Name& called, const Value& number)
      : place(place_called(called)), value(taken(number)), name(called) {}

private:
  template <class Value>
  static constexpr Scalar taken(const Value& number) {
    if constexpr (std::convertible_to<Value, Scalar>)
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
