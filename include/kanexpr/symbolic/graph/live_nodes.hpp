#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

namespace kanexpr::symbolic {

/// Whether the second operand is a value, as opposed to the end of a list, an order or an index.
constexpr bool is_value(const node& n) {
  return n.op == operation::pair ? n.b != graph::zero : !has_index_operand(n.op);
}

/// Marks the nodes that `outputs` need, except constants that end lists or represent orders and indices.
constexpr sequence<char> live_nodes(const graph& g, const sequence<int>& outputs) {
  sequence<char> marks(g.size(), 0);
  const node* const nodes = g.begin(); // a pointer, because compilers interpret every call to operator[]
  char* const live = marks.begin();
  int last = -1;
  for (int id : outputs) {
    live[id] = 1;
    if (id > last) last = id;
  }
  for (int id = last; id >= 0; --id) {
    if (live[id] == 0) continue;
    const node& n = nodes[id];
    if (n.op <= operation::symbol) continue; // a leaf, tested without a call
    live[n.a] = 1;
    if (n.op <= operation::power) {
      if (n.op != operation::negate) live[n.b] = 1;
    } else if (is_binary(n.op) && (n.op < operation::pair || is_value(n))) {
      live[n.b] = 1;
    }
  }
  return marks;
}

/// The live nodes except lists, in ascending order, so operands precede their users.
constexpr sequence<int> live_values(const graph& g, const sequence<int>& outputs) {
  const sequence<char> marks = live_nodes(g, outputs);
  const node* const nodes = g.begin();
  const char* const live = marks.begin();
  sequence<int> values;
  for (int id = 0, end = g.size(); id < end; ++id)
    if (live[id] != 0 && nodes[id].op != operation::pair) values.push(id);
  return values;
}

/// Whether `outputs` depend on any of the nodes in `some`.
constexpr bool depends_on(const graph& g, const sequence<int>& outputs, const sequence<int>& some) {
  const sequence<char> live = live_nodes(g, outputs);
  for (int id : some)
    if (id < live.size() && live[id] != 0) return true;
  return false;
}

} // namespace kanexpr::symbolic
