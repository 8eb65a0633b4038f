#pragma once

#include <kanexpr/symbolic/graph.hpp>

namespace kanexpr::symbolic {

/// What one evaluation does. Subtractions count as additions, a square as one multiplication; signs are free;
/// the sine and cosine of one angle are one trigonometric call. `other` are the remaining functions.
struct cost {
  int multiplications = 0;
  int additions = 0;
  int divisions = 0;
  int trigonometric = 0;
  int other = 0;
  int nodes = 0; ///< all operations, signs included; inputs and constants not

  constexpr bool operator==(const cost&) const = default;

  constexpr void count(operation op) {
    ++nodes;
    switch (op) {
    case operation::constant:
    case operation::symbol:
    case operation::negate: break;
    case operation::add:
    case operation::subtract: ++additions; break;
    case operation::multiply: ++multiplications; break;
    case operation::divide: ++divisions; break;
    case operation::sin:
    case operation::cos:
    case operation::tan:
    case operation::asin:
    case operation::acos:
    case operation::atan:
    case operation::atan2: ++trigonometric; break;
    default: ++other; break;
    }
  }
};

/// Marks the nodes that `outputs` need.
constexpr sequence<char> live_nodes(const graph& g, const sequence<int>& outputs) {
  sequence<char> live(g.size(), 0);
  for (int id : outputs) live[id] = 1;
  for (int id = g.size() - 1; id >= 0; --id) {
    const node& n = g[id];
    if (live[id] == 0 || is_leaf(n.op)) continue;
    live[n.a] = 1;
    if (is_binary(n.op)) live[n.b] = 1;
  }
  return live;
}

constexpr cost cost_of(const graph& g, const sequence<int>& outputs) {
  const sequence<char> live = live_nodes(g, outputs);
  cost total;
  for (int id = 0; id < g.size(); ++id) {
    const node& n = g[id];
    if (live[id] == 0 || is_leaf(n.op)) continue;
    total.count(n.op);
    if (n.op != operation::cos) continue;
    const int sine = g.find({operation::sin, n.a, 0});
    if (sine >= 0 && live[sine] != 0) --total.trigonometric;
  }
  return total;
}

} // namespace kanexpr::symbolic
