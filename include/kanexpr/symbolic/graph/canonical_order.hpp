#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/base/zeros.hpp>
#include <kanexpr/symbolic/graph/build.hpp>
#include <kanexpr/symbolic/graph/external.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

#include <bit>
#include <cstdint>

/// A node order that depends only on the expressions. Node numbers depend on the nodes that were built
/// earlier and, in user-written expressions, on the order in which a compiler evaluates operands.
namespace kanexpr::symbolic {

namespace detail {

/// Hashes that distinguish expressions independently of their node numbers.
class structural_hashes {
public:
  /// Of the nodes that the outputs need.
  constexpr structural_hashes(const graph& g, const sequence<int>& outputs) : marks_(g.size()) {
    base::zeros<char> is_needed(g.size());
    char* const needed = is_needed.begin(); // pointers, because compilers interpret every call
    const node* const nodes = g.begin();
    mark_ = marks_.begin();
    int last = -1;
    for (int id : outputs) {
      needed[id] = 1;
      if (id > last) last = id;
    }
    for (int id = last; id >= 0; --id) {
      if (needed[id] == 0) continue;
      const node& n = nodes[id];
      if (n.op <= operation::symbol) continue; // a leaf
      needed[n.a] = 1;
      if (is_binary(n.op)) needed[n.b] = 1;
    }
    for (int id = 0; id <= last; ++id)
      if (needed[id] != 0) mark_[id] = of(g, nodes[id], id);
  }
  structural_hashes(const structural_hashes&) = delete;
  structural_hashes& operator=(const structural_hashes&) = delete;

  constexpr std::uint64_t operator[](int id) const { return mark_[id]; }

private:
  constexpr std::uint64_t of(const graph& g, const node& n, int id) const {
    std::uint64_t mark = hash_combine(number_of(n.op), 1);
    if (n.op == operation::constant) {
      const number& value = g.number_at(id);
      mark = hash_combine(mark, static_cast<std::uint64_t>(value.numerator));
      mark = hash_combine(mark, static_cast<std::uint64_t>(value.denominator));
      return hash_combine(mark, std::bit_cast<std::uint64_t>(value.real));
    }
    if (n.op == operation::symbol) {
      const symbol& s = g.symbol_at(id);
      mark = hash_combine(mark, static_cast<std::uint64_t>(s.kind));
      for (char letter : s.called.view()) mark = hash_combine(mark, static_cast<std::uint64_t>(letter));
      return mark;
    }
    if (n.op == operation::call) {
      for (char letter : g.external_at(id).called.view())
        mark = hash_combine(mark, static_cast<std::uint64_t>(letter));
      return hash_combine(mark, mark_[n.a]);
    }
    const std::uint64_t a = mark_[n.a], b = is_binary(n.op) ? mark_[n.b] : 0;
    const bool exchanged = is_commutative(n.op) && b < a;
    return hash_combine(hash_combine(mark, exchanged ? b : a), exchanged ? a : b);
  }

  /// The number that identifies an operation in hashes. Adding functions does not renumber the existing ones,
  /// so existing models keep their order.
  static constexpr std::uint64_t number_of(operation op) {
    constexpr int first_selection = 23, first_new = 64;
    const int place = static_cast<int>(op), selections = static_cast<int>(operation::if_positive);
    if (place < first_selection) return static_cast<std::uint64_t>(place);
    return static_cast<std::uint64_t>(place < selections ? place - first_selection + first_new
                                                         : place - selections + first_selection);
  }

  /// Steele, Lea & Flood, Fast splittable pseudorandom number generators (2014).
  static constexpr std::uint64_t hash_combine(std::uint64_t mark, std::uint64_t more) {
    std::uint64_t z = mark * 0x9e3779b97f4a7c15u + more;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  base::zeros<std::uint64_t> marks_;
  std::uint64_t* mark_ = nullptr; ///< the same
};

} // namespace detail

/// Returns the nodes that the outputs depend on, each before its operands.
constexpr sequence<int> reverse_topological_order(const graph& g, const sequence<int>& outputs) {
  const detail::structural_hashes mark(g, outputs);
  base::zeros<char> states(g.size());
  char* const state = states.begin(); // 1: operands are listed first; 2: listed
  const node* const nodes = g.begin();
  sequence<int> open, operands_first;
  for (int i = outputs.size() - 1; i >= 0; --i) open.push(outputs[i]);
  while (!open.empty()) {
    const int id = open.back();
    const node& n = nodes[id];
    if (state[id] != 0 || is_leaf(n.op)) {
      open.pop();
      if (state[id] == 2) continue;
      state[id] = 2;
      operands_first.push(id);
      continue;
    }
    state[id] = 1;
    const bool binary = is_binary(n.op), exchanged = binary && is_commutative(n.op) && mark[n.b] < mark[n.a];
    if (binary && state[exchanged ? n.a : n.b] == 0) open.push(exchanged ? n.a : n.b);
    if (state[exchanged ? n.b : n.a] == 0) open.push(exchanged ? n.b : n.a);
  }
  sequence<int> order;
  for (int i = operands_first.size() - 1; i >= 0; --i) order.push(operands_first[i]);
  return order;
}

/// Copies nodes, together with the expressions they need, to another graph; returns their new numbers, which
/// follow the canonical order.
inline sequence<int> copy_nodes(const graph& from, const sequence<int>& wanted, graph& to) {
  for (const external_function* f : from.externals()) to.externals().push(f);
  sequence<int> place(from.size(), graph::zero);
  const sequence<int> order = reverse_topological_order(from, wanted);
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
