#pragma once

#include <kanexpr/derive/derived_system.hpp>
#include <kanexpr/lower/tape.hpp>

#include <initializer_list>

namespace kanexpr::derivation {

/// What `function<System, wanted…>::cost()` says, by the same derivation while the program runs.
template <class System>
constexpr symbolic::cost cost_of(std::initializer_list<mechanics::quantity> wanted) {
  derived_system system(System::record);
  system.derive();
  symbolic::sequence<int> outputs;
  for (const mechanics::quantity one : wanted) {
    const symbolic::matrix result = system.equations().get(one);
    for (const expression& entry : result.entries) outputs.push(entry.node());
  }
  for (const mechanics::guard& g : system.equations().guards_of(outputs)) {
    outputs.push(g.measure.node());
    outputs.push(g.scale.node());
  }
  return lower::cost_of(lower::tape_of(system.graph(), outputs));
}

} // namespace kanexpr::derivation
