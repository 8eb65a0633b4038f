#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/live_nodes.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

#include <bit>
#include <cstdint>

namespace kanexpr::symbolic {

/// Estimates the operations of a Jacobian by forward differentiation, by reverse accumulation, and by both:
/// forward with respect to some symbols, reverse with respect to the others. A symbol that few operations
/// depend on, as the angle of the last joint of an arm, is cheaper by forward differentiation.
///
/// Forward differentiation visits each operation once for each symbol on which it depends, reverse
/// accumulation once for each result that depends on it. Shared results of these visits are not predicted.
class jacobian_modes {
public:
  /// Held expressions count as constants.
  constexpr jacobian_modes(const graph& g, const sequence<int>& outputs, const sequence<expression>& symbols,
                           const sequence<expression>& held)
      : g_(g), symbols_(symbols.size()), words_((symbols.size() + 63) / 64), live_(live_nodes(g, outputs)),
        depends_(live_.size() * words_, 0), active_(live_.size(), 0), users_(live_.size(), 0),
        reverse_(live_.size(), 0), forward_(symbols.size(), 0), is_forward_(symbols.size(), 0) {
    for (int j = 0; j < symbols_; ++j)
      if (const int id = symbols[j].node(); id < live_.size())
        depends_[id * words_ + j / 64] = bit_of(j), active_[id] = 1;
    sequence<char> is_held(live_.size(), 0);
    for (const expression& e : held)
      if (e.node() < live_.size()) is_held[e.node()] = 1;
    for (int id = 0; id < live_.size(); ++id)
      if (live_[id] != 0 && !is_leaf(g[id].op) && is_held[id] == 0) visit_operands(id);
    count_forward(is_held);
    count_reverse(outputs, is_held);
    choose();
  }

  /// Whether forward differentiation is cheaper with respect to symbol `j`.
  constexpr bool is_forward(int j) const { return is_forward_[j] != 0; }
  /// The estimated operations by forward differentiation with respect to all symbols.
  constexpr int by_forward() const { return all_forward_; }
  /// The estimated operations of the choice, before forward differentiation with respect to all symbols is
  /// considered.
  constexpr int by_both() const { return mixed_; }

private:
  using word = std::uint64_t;

  static constexpr word bit_of(int j) { return word{1} << (j % 64); }

  constexpr void visit_operands(int id) {
    const node& n = g_[id];
    const bool is_of_two = is_binary(n.op);
    ++users_[n.a];
    if (is_of_two) ++users_[n.b];
    if (active_[n.a] == 0 && (!is_of_two || active_[n.b] == 0)) return;
    active_[id] = 1;
    const int own = id * words_, first = n.a * words_, second = n.b * words_;
    word* const all = depends_.begin() + own;
    const word *const a = depends_.begin() + first, *const b = depends_.begin() + second;
    for (int w = 0; w < words_; ++w) all[w] = is_of_two ? a[w] | b[w] : a[w];
  }

  /// Counts operations for each symbol on which `a` depends or, if b is given, on which both depend.
  constexpr void charge(int a, int b = -1) {
    if (active_[a] == 0 || (b >= 0 && active_[b] == 0)) return;
    const word* const of = depends_.begin();
    int* const charged = forward_.begin();
    for (int w = 0; w < words_; ++w) {
      word left = of[a * words_ + w];
      if (b >= 0) left &= of[b * words_ + w];
      for (; left != 0; left &= left - 1) ++charged[64 * w + std::countr_zero(left)];
    }
  }
  /// Counts a product with the rate of an operand; the rate of a symbol is 1.
  constexpr void charge_product(int operand) {
    if (g_[operand].op != operation::symbol) charge(operand);
  }

  constexpr void count_forward(const sequence<char>& is_held) {
    sequence<char> is_within(live_.size(), 0); // a product that belongs to one rotated component only
    for (int id = live_.size() - 1; id >= 0; --id) {
      if (live_[id] == 0 || is_leaf(g_[id].op) || is_held[id] != 0 || is_within[id] != 0 || active_[id] == 0)
        continue;
      const node& n = g_[id];
      if (const rotated_component x = rotated_component_at(g_, n)) {
        for (int product : {n.a, n.b})
          if (users_[product] == 1) is_within[product] = 1;
        charge_product(x.value[0]), charge_product(x.value[1]), charge_product(x.angle);
        charge(x.value[0], x.value[1]), charge(x.value[0], x.angle);
        continue;
      }
      const bool is_of_two = is_binary(n.op);
      if (is_of_two) charge(n.a, n.b);
      if (n.op == operation::add || n.op == operation::subtract || n.op == operation::negate) continue;
      charge_product(n.a);
      if (is_of_two && n.b != n.a) charge_product(n.b);
    }
    for (int each : forward_) all_forward_ += each;
  }

  constexpr void count_reverse(const sequence<int>& outputs, const sequence<char>& is_held) {
    const int words = (outputs.size() + 63) / 64;
    sequence<word> reached(live_.size() * words, 0); // the outputs that depend on each node
    sequence<char> is_unit(live_.size(), 0);         // whether the adjoint is 1 or −1
    for (int i = 0; i < outputs.size(); ++i) {
      reached[outputs[i] * words + i / 64] |= bit_of(i);
      is_unit[outputs[i]] = 1;
      ++reverse_[outputs[i]];
    }
    const auto pass = [&](int from, int to, int count, bool is_product) {
      if (active_[to] == 0) return;
      for (int w = 0; w < words; ++w) reached[to * words + w] |= reached[from * words + w];
      reverse_[to] += count;
      if (is_product && is_unit[from] == 0) reverse_[to] += count;
      if (!is_product && is_unit[from] != 0 && users_[to] == 1) is_unit[to] = 1;
    };
    for (int id = live_.size() - 1; id >= 0; --id) {
      if (live_[id] == 0 || active_[id] == 0) continue;
      int count = 0;
      for (int w = 0; w < words; ++w) count += std::popcount(reached[id * words + w]);
      reverse_[id] -= count; // the first of several parts of an adjoint is not added to anything
      const node& n = g_[id];
      if (is_leaf(n.op) || is_held[id] != 0 || count == 0) continue;
      if (const rotated_component x = rotated_component_at(g_, n);
          x && users_[n.a] == 1 && users_[n.b] == 1) {
        for (int operand : {x.value[0], x.value[1], x.angle}) pass(id, operand, count, true);
        continue;
      }
      const bool is_product =
          n.op != operation::add && n.op != operation::subtract && n.op != operation::negate;
      pass(id, n.a, count, is_product);
      if (is_binary(n.op)) pass(id, n.b, count, is_product);
    }
  }

  /// Starts with reverse accumulation for all symbols. A symbol changes if this saves operations: those of
  /// the nodes that depend on it, but on no other remaining symbol.
  constexpr void choose() {
    sequence<word> remaining(words_, 0);
    for (int j = 0; j < symbols_; ++j) remaining[j / 64] |= bit_of(j);
    for (bool changes = true; changes;) {
      changes = false;
      int total = 0;
      sequence<int> own(symbols_, 0);
      const word *const of = depends_.begin(), *const still = remaining.begin();
      const char* const active = active_.begin();
      for (int id = 0, end = live_.size(); id < end; ++id) {
        if (active[id] == 0) continue;
        int bits = 0; // of the remaining symbols: none, one or several
        int only = 0;
        for (int w = 0; w < words_ && bits < 2; ++w)
          if (const word left = of[id * words_ + w] & still[w]; left != 0) {
            bits += (left & (left - 1)) == 0 ? 1 : 2;
            only = 64 * w + std::countr_zero(left);
          }
        if (bits == 0) continue;
        total += reverse_[id];
        if (bits == 1) own[only] += reverse_[id];
      }
      mixed_ = total;
      for (int j = 0; j < symbols_; ++j) {
        if (is_forward_[j] != 0) {
          mixed_ += forward_[j];
        } else if (forward_[j] < own[j]) {
          is_forward_[j] = 1;
          remaining[j / 64] &= ~bit_of(j);
          changes = true;
        }
      }
    }
  }

  const graph& g_;
  int symbols_, words_;
  sequence<char> live_;
  sequence<word> depends_;    ///< the symbols on which each node depends, as bits
  sequence<char> active_;     ///< whether a node depends on any symbol
  sequence<int> users_;       ///< the number of users of each node
  sequence<int> reverse_;     ///< the operations for the adjoint of each node
  sequence<int> forward_;     ///< the operations for each symbol
  sequence<char> is_forward_; ///< by symbol
  int all_forward_ = 0, mixed_ = 0;
};

} // namespace kanexpr::symbolic
