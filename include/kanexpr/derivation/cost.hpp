#pragma once

#include <kanexpr/derivation/extract_code.hpp>
#include <kanexpr/lower/tape_cost.hpp>

#include <initializer_list>
#include <vector>

namespace kanexpr::derivation {

/// Returns the same value as `function<System, wanted…>::cost()`, obtained by the same derivation at run
/// time.
template <class System>
symbolic::cost cost_of(std::initializer_list<quantity> wanted) {
  std::vector<request> all;
  for (const quantity one : wanted) all.push_back({.what = request::kind::result, .wanted = one});
  derived_system system(System::record);
  advance(system, stage::constrained);
  for (const stage next : {stage::equations, stage::linearized})
    if (stage_for(all) >= next) advance(system, next);
  return lower::cost_of(lower::tape_of(system.graph(), nodes_for(system, all).nodes));
}

} // namespace kanexpr::derivation
