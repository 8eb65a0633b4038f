#pragma once

#include <kanexpr/symbolic/linear/expand_solves.hpp>
#include <kanexpr/symbolic/polynomials/budget.hpp>

#include <vector>

namespace kanexpr::symbolic::algebra {

/// Whether a node is taken as a whole: what it is made of is a list, and no value.
constexpr bool is_atomic(operation op) { return is_leaf(op) || op >= operation::pair; }

/// Gives a value to every node under some outputs, once, and forgets it after its last use: shared parts are
/// never repeated. `value_of(id, a, b)` has the values of the operands; `size_of` says how many terms one
/// has. Returns nothing where the budget does not suffice.
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
    const node n = g[id]; // the graph may grow
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

/// The outputs with small linear systems written out, where there are any.
inline sequence<int> without_small_solves(graph& g, const sequence<int>& outputs) {
  return holds_solves(g, live_nodes(g, outputs)) ? expand_solves(g, outputs) : outputs;
}

} // namespace kanexpr::symbolic::algebra
