#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/multibody_system.hpp>
#include <kanexpr/runtime/each_expression.ipp>
#include <kanexpr/symbolic/graph/canonical_order.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>

namespace kanexpr::runtime {

/// Moves a system to a separate graph. In the graph of a builder, which its models share, the numbering of
/// the nodes depends on the order in which the compiler evaluates operands; in a separate graph, it does not.
inline void move_to(symbolic::graph& own, mechanics::multibody_system& system) {
  const symbolic::graph& shared = *system.mechanism.g;
  base::sequence<int> nodes;
  const auto collect = [&](const symbolic::expression& e) {
    if (e.belongs_to(shared)) nodes.push(e.node());
  };
  each_expression{collect}(system);
  const base::sequence<int> place = symbolic::copy_nodes(shared, nodes, own);
  const auto move = [&](symbolic::expression& e) {
    if (e.belongs_to(shared)) e = {own, place[e.node()]};
  };
  each_expression{move}(system);
  system.mechanism.g = &own;
}

} // namespace kanexpr::runtime
