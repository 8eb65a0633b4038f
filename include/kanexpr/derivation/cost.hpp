#pragma once

#include <kanexpr/derivation/reader.hpp>
#include <kanexpr/lower/tape.hpp>
#include <kanexpr/mechanics/equations.hpp>

#include <initializer_list>

namespace kanexpr::derivation {

/// What `function<System, wanted…>::cost()` says, by the same derivation while the program runs.
template <class System>
constexpr symbolic::cost cost_of(std::initializer_list<mechanics::quantity> wanted) {
  symbolic::graph g;
  mechanism m(g);
  reader r(System::record, m);
  r.read();
  mechanics::equations e(m);
  symbolic::sequence<int> outputs;
  for (const mechanics::quantity one : wanted) {
    const symbolic::matrix result = e.get(one);
    for (const expression& entry : result.entries) outputs.push(entry.node());
  }
  return lower::cost_of(lower::tape_of(g, outputs));
}

} // namespace kanexpr::derivation
