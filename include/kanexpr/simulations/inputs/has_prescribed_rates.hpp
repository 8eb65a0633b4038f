#pragma once

#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

namespace kanexpr::simulations {

/// Whether rates of prescribed quantities are among the inputs.
constexpr bool has_prescribed_rates(const derivation::survey& known) {
  const int first = known.first_of(symbolic::symbol_kind::input);
  for (int i = 0; i < known.inputs; ++i)
    if (known.names[first + i].view().ends_with('\'')) return true;
  return false;
}

} // namespace kanexpr::simulations
