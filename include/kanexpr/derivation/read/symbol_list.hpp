#pragma once

#include <string_view>

namespace kanexpr::derivation {

/// The uses of a model's names, each of which has a single meaning.
enum class symbol_list : unsigned char {
  coordinates,
  rates_of_coordinates,
  speeds,
  auxiliary_speeds,
  values,
  parameters,
  inputs,
  times,
};

/// Returns the name of the list as it appears in error messages.
constexpr std::string_view called(symbol_list list) {
  switch (list) {
  case symbol_list::coordinates: return "coordinates";
  case symbol_list::rates_of_coordinates: return "rates of coordinates";
  case symbol_list::speeds: return "speeds";
  case symbol_list::auxiliary_speeds: return "auxiliary speeds";
  case symbol_list::values: return "values";
  case symbol_list::parameters: return "parameters";
  case symbol_list::inputs: return "inputs";
  case symbol_list::times: return "symbols for the time";
  }
  return {};
}

} // namespace kanexpr::derivation
