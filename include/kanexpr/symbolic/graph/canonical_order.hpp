#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

#include <bit>
#include <cstdint>

/// A node order that depends only on the expressions. Node numbers depend on the nodes that were built before
/// and, in user-written expressions, on the order in which a compiler evaluates operands.
namespace kanexpr::symbolic {

namespace detail {

/// Hashes that distinguish expressions independently of their node numbers.
class marks {
public:
  constexpr explicit marks(const graph& g) : mark_(g.size(), 0) {
    for (int id = 0; id < g.size(); ++id) mark_[id] = of(g, g[id], id);
  }
  constexpr std::uint64_t operator[](int id) const { return mark_[id]; }

private:
  constexpr std::uint64_t of(const graph& g, const node& n, int id) const {
    std::uint64_t mark = mix(number_of(n.op), 1);
    if (n.op == operation::constant) {
      const number& value = g.number_at(id);
      mark = mix(mark, static_cast<std::uint64_t>(value.numerator));
      mark = mix(mark, static_cast<std::uint64_t>(value.denominator));
      return mix(mark, std::bit_cast<std::uint64_t>(value.real));
    }
    if (n.op == operation::symbol) {
      const symbol& s = g.symbol_at(id);
      mark = mix(mark, static_cast<std::uint64_t>(s.kind));
      for (char letter : s.called.view()) mark = mix(mark, static_cast<std::uint64_t>(letter));
      return mark;
    }
    if (n.op == operation::call) {
      for (char letter : g.external_at(id).called.view())
        mark = mix(mark, static_cast<std::uint64_t>(letter));
      return mix(mark, mark_[n.a]);
    }
    const std::uint64_t a = mark_[n.a], b = is_binary(n.op) ? mark_[n.b] : 0;
    const bool exchanged = is_commutative(n.op) && b < a;
    return mix(mix(mark, exchanged ? b : a), exchanged ? a : b);
  }

  /// A number that functions added later do not change, so that existing models keep their order.
  static constexpr std::uint64_t number_of(operation op) {
    constexpr int first_selection = 23, first_new = 64;
    const int place = static_cast<int>(op), selections = static_cast<int>(operation::if_positive);
    if (place < first_selection) return static_cast<std::uint64_t>(place);
    return static_cast<std::uint64_t>(place < selections ? place - first_selection + first_new
                                                         : place - selections + first_selection);
  }

  /// Steele, Lea & Flood, Fast splittable pseudorandom number generators (2014).
  static constexpr std::uint64_t mix(std::uint64_t mark, std::uint64_t more) {
    std::uint64_t z = mark * 0x9e3779b97f4a7c15u + more;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  sequence<std::uint64_t> mark_;
};

} // namespace detail

/// Returns the nodes that the outputs depend on, each before its operands.
constexpr sequence<int> users_first(const graph& g, const sequence<int>& outputs) {
  const detail::marks mark(g);
  sequence<char> met(g.size(), 0); // 1: operands are listed first; 2: listed
  sequence<int> open, operands_first;
  for (int i = outputs.size() - 1; i >= 0; --i) open.push(outputs[i]);
  while (!open.empty()) {
    const int id = open.back();
    const node& n = g[id];
    if (met[id] != 0 || is_leaf(n.op)) {
      open.pop();
      if (met[id] == 2) continue;
      met[id] = 2;
      operands_first.push(id);
      continue;
    }
    met[id] = 1;
    const bool binary = is_binary(n.op), exchanged = binary && is_commutative(n.op) && mark[n.b] < mark[n.a];
    if (binary && met[exchanged ? n.a : n.b] == 0) open.push(exchanged ? n.a : n.b);
    if (met[exchanged ? n.b : n.a] == 0) open.push(exchanged ? n.b : n.a);
  }
  sequence<int> order;
  for (int i = operands_first.size() - 1; i >= 0; --i) order.push(operands_first[i]);
  return order;
}

} // namespace kanexpr::symbolic
