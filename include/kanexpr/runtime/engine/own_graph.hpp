#pragma once

#include <kanexpr/mechanics/multibody_system.hpp>
#include <kanexpr/runtime/engine/each_expression.hpp>
#include <kanexpr/symbolic/graph/copied.hpp>

namespace kanexpr::runtime {

/// Gives a system a graph of its own. What users write numbers its nodes in the order in which their compiler
/// evaluates operands, and models of one builder share a graph; here neither matters.
inline void move_to(symbolic::graph& own, mechanics::multibody_system& system) {
  const symbolic::graph& shared = *system.mechanism.g;
  symbolic::sequence<int> nodes;
  const auto collect = [&](const symbolic::expression& e) {
    if (e.lives_in(shared)) nodes.push(e.node());
  };
  each_expression{collect}(system);
  const symbolic::sequence<int> place = symbolic::copied(shared, nodes, own);
  const auto move = [&](symbolic::expression& e) {
    if (e.lives_in(shared)) e = {own, place[e.node()]};
  };
  each_expression{move}(system);
  system.mechanism.g = &own;
}

} // namespace kanexpr::runtime
