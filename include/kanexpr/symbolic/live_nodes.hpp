#pragma once

#include <kanexpr/symbolic/graph.hpp>

namespace kanexpr::symbolic {

/// Whether the second operand is not the end of a list, an order or an index.
constexpr bool is_value(const node& n) {
  return n.op == operation::pair ? n.b != graph::zero : !is_numbered(n.op);
}

/// Marks the nodes that `outputs` need; not the numbers by which lists are ended, orders and indices given.
constexpr sequence<char> live_nodes(const graph& g, const sequence<int>& outputs) {
  sequence<char> live(g.size(), 0);
  for (int id : outputs) live[id] = 1;
  for (int id = g.size() - 1; id >= 0; --id) {
    const node& n = g[id];
    if (live[id] == 0 || is_leaf(n.op)) continue;
    live[n.a] = 1;
    if (is_binary(n.op) && (n.op < operation::pair || is_value(n))) live[n.b] = 1;
  }
  return live;
}

} // namespace kanexpr::symbolic
