#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/base/zeros.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/live_nodes.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/linear/linear_system.hpp>

namespace kanexpr::mechanics {

/// A sum ±u̇ + e that is the only part of the equations in which a rate u̇ appears; e contains no rates.
///
/// The velocity of a free body is an example: u̇ occurs only in the acceleration u̇ + ω × v − g, in the axes of
/// the body. If a state changes the equations only through e, then u̇ changes by ∓δe, and nothing else
/// changes.
struct combined_rate {
  int speed = 0;
  expression sum{};
  bool is_negative = false; ///< −u̇ + e
};

/// Finds such sums, at most one for each rate, in the given equations.
constexpr sequence<combined_rate> combined_rates(const sequence<expression>& equations,
                                                 const sequence<expression>& rates) {
  using symbolic::operation;
  sequence<combined_rate> found;
  if (equations.empty()) return found;
  symbolic::graph& g = equations[0].owner();
  const sequence<int> outputs = symbolic::nodes_of(equations);
  const base::zeros<char> live = symbolic::live_nodes(g, outputs);
  constexpr int several = -1;
  // for each live node, its only user; and whether it depends on any rate
  base::zeros<int> users(live.size());
  base::zeros<char> with_rates(live.size());
  for (const expression& rate : rates)
    if (rate.node() < live.size()) with_rates[rate.node()] = 1;
  for (int id = 0; id < live.size(); ++id) {
    if (live[id] == 0) continue;
    const symbolic::node& n = g[id];
    if (symbolic::is_leaf(n.op)) continue;
    users[n.a] = users[n.a] == 0 ? id : several;
    if (with_rates[n.a] != 0) with_rates[id] = 1;
    if (!symbolic::is_binary(n.op)) continue;
    users[n.b] = users[n.b] == 0 ? id : several;
    if (with_rates[n.b] != 0) with_rates[id] = 1;
  }
  for (int id : outputs) users[id] = several;
  for (int k = 0; k < rates.size(); ++k) {
    combined_rate candidate{k, rates[k], false};
    int id = rates[k].node();
    while (id < live.size() && live[id] != 0 && users[id] > 0) {
      const int by = users[id];
      const symbolic::node& n = g[by];
      if (n.op != operation::add && n.op != operation::subtract) break;
      const int other = n.a == id ? n.b : n.a;
      if (with_rates[other] != 0) break;
      if (n.op == operation::subtract && n.b == id) candidate.is_negative = !candidate.is_negative;
      id = by;
    }
    if (id == rates[k].node()) continue;
    candidate.sum = {g, id};
    found.push(candidate);
  }
  return found;
}

} // namespace kanexpr::mechanics
