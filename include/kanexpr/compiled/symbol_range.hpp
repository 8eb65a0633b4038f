#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <string_view>

namespace kanexpr::compiled {

enum class symbols_of : unsigned char { state, parameters, inputs };

/// The symbols of a vector of values, which are contiguous in a survey.
struct symbol_range {
  int first = 0, size = 0;
  std::string_view vector; ///< "state"
  std::string_view symbol; ///< "coordinate or speed"

  constexpr bool holds(int place) const { return place >= first && place < first + size; }
};

constexpr symbol_range range_of(symbols_of which, const derivation::survey& s) {
  using symbolic::symbol_kind;
  switch (which) {
  case symbols_of::parameters:
    return {s.first_of(symbol_kind::parameter), s.parameters, "parameter", "parameter"};
  case symbols_of::inputs: return {s.first_of(symbol_kind::input), s.inputs, "input", "input"};
  case symbols_of::state: break;
  }
  if (s.state_variables != 0)
    return {0, s.coordinates + s.speeds, "state",
            s.takes_rates_as_speeds ? "coordinate, rate or state variable"
                                    : "coordinate, speed or state variable"};
  return {0, s.coordinates + s.speeds, "state",
          s.takes_rates_as_speeds ? "coordinate or rate" : "coordinate or speed"};
}

/// Returns the name of the symbol at an index of a survey, such as "coordinate q1", "speed u1" (with
/// Lagrange's method "the rate of coordinate q1"), "parameter m" or "input T".
constexpr base::sentence symbol_called(const derivation::survey& known, int place) {
  using symbolic::symbol_kind;
  const std::string_view name = known.names[place].view();
  if (place >= known.first_of(symbol_kind::input)) return base::sentence({"input ", name});
  if (place >= known.first_of(symbol_kind::parameter)) return base::sentence({"parameter ", name});
  if (place < known.coordinates) return base::sentence({"coordinate ", name});
  if (place >= known.first_state_variable()) return base::sentence({"state variable ", name});
  if (!known.takes_rates_as_speeds) return base::sentence({"speed ", name});
  return base::sentence({"the rate of coordinate ", name.substr(0, name.size() - 1)});
}

} // namespace kanexpr::compiled
