#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/base/zeros.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

#include <cstddef>
#include <type_traits>

namespace kanexpr::symbolic {

/// Whether the second operand is a value, as opposed to the end of a list, an order or an index.
constexpr bool is_value(const node& n) {
  return n.op == operation::pair ? n.b != graph::zero : !has_index_operand(n.op);
}

namespace detail {

/// Marks the operands of all marked nodes. Lists all marked nodes, unless `listed` is null, and returns how
/// many there are.
template <class Nodes, class Marks, class List>
constexpr int mark_operands(const Nodes& nodes, Marks& live, int last, List& listed) {
  int count = 0;
  for (int id = last; id >= 0; --id) {
    if (live[id] == 0) continue;
    if constexpr (!std::is_null_pointer_v<List>) listed[count++] = id;
    const operation op = nodes[id].op;
    if (op <= operation::symbol) continue; // a leaf, tested without a call
    live[nodes[id].a] = 1;
    if (op <= operation::power) {
      if (op != operation::negate) live[nodes[id].b] = 1;
    } else if (is_binary(op) && (op < operation::pair || is_value(nodes[id]))) {
      live[nodes[id].b] = 1;
    }
  }
  return count;
}

/// Writes zeros in ascending order: where elements are written in descending order, g++ moves all that are
/// there for each.
template <class Marks>
constexpr void clear(Marks& marks, int count) {
  for (int id = 0; id < count; ++id) marks[id] = 0;
}

/// Marks outputs, and returns the last of them; -1 if there are none.
constexpr int mark(const sequence<int>& outputs, base::zeros<char>& marks) {
  int last = -1;
  for (int id : outputs)
    if (id > last) last = id;
  if (__builtin_is_constant_evaluated()) clear(marks.elements<true>(), last + 1);
  char* const live = marks.begin();
  for (int id : outputs) live[id] = 1;
  return last;
}

} // namespace detail

/// Marks the nodes that `outputs` need, except constants that end lists or represent orders and indices.
constexpr base::zeros<char> live_nodes(const graph& g, const sequence<int>& outputs) {
  base::zeros<char> marks(g.size());
  const int last = detail::mark(outputs, marks);
  std::nullptr_t nothing = nullptr;
  if (__builtin_is_constant_evaluated())
    detail::mark_operands(g.elements<true>(), marks.elements<true>(), last, nothing);
  else
    detail::mark_operands(g.elements<false>(), marks.elements<false>(), last, nothing);
  return marks;
}

/// The same marks, and the nodes in descending order, so users precede their operands.
struct live_list {
  base::zeros<char> marks;
  base::zeros<int> nodes;
  int count = 0;

  constexpr live_list(const graph& g, const sequence<int>& outputs) : marks(g.size()), nodes(g.size()) {
    const int last = detail::mark(outputs, marks);
    if (__builtin_is_constant_evaluated())
      count = detail::mark_operands(g.elements<true>(), marks.elements<true>(), last, nodes.elements<true>());
    else
      count =
          detail::mark_operands(g.elements<false>(), marks.elements<false>(), last, nodes.elements<false>());
  }
};

/// The live nodes except lists, in ascending order, so operands precede their users.
constexpr sequence<int> live_values(const graph& g, const sequence<int>& outputs) {
  const base::zeros<char> marks = live_nodes(g, outputs);
  const node* const nodes = g.begin();
  const char* const live = marks.begin();
  sequence<int> values;
  for (int id = 0, end = g.size(); id < end; ++id)
    if (live[id] != 0 && nodes[id].op != operation::pair) values.push(id);
  return values;
}

/// Whether `outputs` depend on any of the nodes in `some`.
constexpr bool depends_on(const graph& g, const sequence<int>& outputs, const sequence<int>& some) {
  const base::zeros<char> live = live_nodes(g, outputs);
  for (int id : some)
    if (id < live.size() && live[id] != 0) return true;
  return false;
}

} // namespace kanexpr::symbolic
