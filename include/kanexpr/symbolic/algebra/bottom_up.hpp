#pragma once

#include <kanexpr/symbolic/linear/expand_solves.hpp>
#include <kanexpr/symbolic/polynomials/budget.hpp>

#include <vector>

namespace kanexpr::symbolic::algebra {

/// Whether a node is treated as a whole: its operands are lists, not values.
constexpr bool is_atomic(operation op) { return is_leaf(op) || op >= operation::pair; }

/// Computes a value for every node below some outputs exactly once, and discards it after its last use.
/// `value_of(id, a, b)` receives the values of the operands; `size_of` returns the number of terms of a
/// value. Returns nothing if the budget is exceeded.
template <class Value, class ValueOf, class SizeOf>
std::vector<Value> bottom_up(const graph& g, const sequence<int>& outputs, budget& left, SizeOf size_of,
                             ValueOf value_of) {
  const auto at = [](auto& all, int id) -> auto& { return all[static_cast<std::size_t>(id)]; };
  const int end = g.size();
  std::vector<int> uses(static_cast<std::size_t>(end), 0);
  for (int id : outputs) ++at(uses, id);
  for (int id = end - 1; id >= 0; --id) {
    const node& n = g[id];
    if (at(uses, id) == 0 || is_atomic(n.op)) continue;
    ++at(uses, n.a);
    if (is_binary(n.op)) ++at(uses, n.b);
  }
  std::vector<Value> values(static_cast<std::size_t>(end));
  std::size_t kept = 0;
  const auto release = [&](int id) {
    if (--at(uses, id) > 0) return;
    kept -= size_of(at(values, id));
    at(values, id) = Value();
  };
  for (int id = 0; id < end; ++id) {
    if (at(uses, id) == 0) continue;
    const node n = g[id]; // a copy, since the graph may grow
    const bool has_operands = !is_atomic(n.op);
    const int second = has_operands && is_binary(n.op) ? n.b : graph::zero;
    at(values, id) = value_of(id, has_operands ? at(values, n.a) : Value(), at(values, second));
    kept += size_of(at(values, id));
    if (!left.allows_together(kept)) return {};
    if (has_operands) release(n.a);
    if (has_operands && is_binary(n.op)) release(n.b);
  }
  std::vector<Value> found;
  for (int id : outputs) found.push_back(at(values, id));
  return found;
}

/// The outputs with small linear systems, if any, expanded.
inline sequence<int> without_small_solves(graph& g, const sequence<int>& outputs) {
  return holds_solves(g, live_nodes(g, outputs)) ? expand_solves(g, outputs) : outputs;
}

} // namespace kanexpr::symbolic::algebra
