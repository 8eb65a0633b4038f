#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/external.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/live_nodes.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/linear/linear_system.hpp>

namespace kanexpr::mechanics {

/// Reports a derivative of an external function that a result requires and the function does not provide.
constexpr base::sentence check_derivatives(const symbolic::matrix& result) {
  if (result.entries.empty() || result.entries[0].owner().externals().empty()) return {};
  const symbolic::graph& g = result.entries[0].owner();
  const base::zeros<char> live = symbolic::live_nodes(g, symbolic::nodes_of(result.entries));
  constexpr const char* which[]{"", "", "second ", "third ", "fourth "};
  for (int id = 0; id < live.size(); ++id) {
    if (live[id] == 0 || g[id].op != symbolic::operation::call) continue;
    const symbolic::external_function& f = g.external_at(id);
    if (!f.is_provided())
      return base::sentence({"the ", which[f.order], "derivative of ", f.original.view(),
                             " is required but not provided; pass it after the function: external<\"",
                             f.original.view(), "\", function, derivative", f.order > 1 ? ", ...>" : ">"});
  }
  return {};
}

} // namespace kanexpr::mechanics
