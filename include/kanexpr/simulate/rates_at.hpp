#pragma once

#include <kanexpr/compiled/out_of_line.hpp>
#include <kanexpr/simulate/surroundings.hpp>

namespace kanexpr::simulated {

/// The rates of a state with the inputs of that time and state; false where there are none.
template <class System>
bool rates_at(surroundings<System>& around, double t, const state<System>& x, state<System>& rates) {
  if (around.take(t, x) != answer::given) return false;
  const auto found = out_of_line<function<System, mechanics::quantity::rhs>>{}(t, x, around.p(), around.r());
  rates = found;
  return static_cast<bool>(compiled::status_of(found)) && rates.allFinite();
}

} // namespace kanexpr::simulated
