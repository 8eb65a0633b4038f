#pragma once

#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <string>
#include <vector>

namespace kanexpr::derivation {

/// The names of the symbols to which the rows or the columns of a result belong; empty if they belong to
/// none.
inline std::vector<std::string> names_along(const survey& known, mechanics::extent_by extent) {
  using enum mechanics::extent_by;
  std::vector<std::string> names;
  const int speeds_begin = known.coordinates, states_end = known.coordinates + known.speeds;
  const auto add = [&](int first, int end, bool only_independent) {
    for (int i = first; i < end; ++i)
      if (!only_independent || !known.dependent[i]) names.emplace_back(known.names[i].view());
  };
  const int first_input = known.first_of(symbolic::symbol_kind::input);
  if (extent == coordinates) add(0, speeds_begin, false);
  if (extent == speeds) add(speeds_begin, states_end, false);
  if (extent == coordinates_and_speeds) add(0, states_end, false);
  if (extent == independent_speeds) add(speeds_begin, states_end, true);
  if (extent == independent_states) add(0, states_end, true);
  if (extent == inputs) add(first_input, first_input + known.inputs, false);
  return names;
}

} // namespace kanexpr::derivation
