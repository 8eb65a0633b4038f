#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/build.hpp>
#include <kanexpr/symbolic/graph/canonical_order.hpp>
#include <kanexpr/symbolic/graph/external.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

namespace kanexpr::symbolic {

/// Copies nodes, together with the expressions they need, to another graph; returns their new numbers, which
/// follow the canonical order.
inline sequence<int> copied(const graph& from, const sequence<int>& wanted, graph& to) {
  for (const external_function* f : from.externals()) to.externals().push(f);
  sequence<int> place(from.size(), graph::zero);
  const sequence<int> order = users_first(from, wanted);
  for (int i = order.size() - 1; i >= 0; --i) {
    const int id = order[i];
    const node n = from[id];
    if (n.op == operation::constant)
      place[id] = to.constant(from.number_at(id));
    else if (n.op == operation::symbol)
      place[id] = to.variable(from.symbol_at(id));
    else
      place[id] = build(to, n.op, place[n.a], is_binary(n.op) ? place[n.b] : 0);
  }
  return place;
}

} // namespace kanexpr::symbolic
