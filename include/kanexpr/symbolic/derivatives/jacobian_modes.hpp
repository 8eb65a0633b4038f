#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/base/zeros.hpp>
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
      : nodes_(g.begin()), size_(g.size()), symbols_(symbols.size()), words_((symbols.size() + 63) / 64),
        of_live_(live_nodes(g, outputs)), of_depends_(size_ * words_), of_active_(size_), of_users_(size_),
        of_reverse_(size_), of_held_(size_), forward_(symbols.size(), 0), is_forward_(symbols.size(), 0),
        live_(of_live_.begin()), active_(of_active_.begin()), is_held_(of_held_.begin()),
        depends_(of_depends_.begin()), users_(of_users_.begin()), reverse_(of_reverse_.begin()) {
    for (int j = 0; j < symbols_; ++j)
      if (const int id = symbols[j].node(); id < size_)
        depends_[id * words_ + j / 64] = bit_of(j), active_[id] = 1;
    for (const expression& e : held)
      if (e.node() < size_) is_held_[e.node()] = 1;
    for (int id = 0; id < size_; ++id)
      if (live_[id] != 0 && nodes_[id].op > operation::symbol && is_held_[id] == 0) visit_operands(id);
    count_forward(g);
    count_reverse(g, outputs);
    choose();
  }
  jacobian_modes(const jacobian_modes&) = delete;
  jacobian_modes& operator=(const jacobian_modes&) = delete;

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
    const node& n = nodes_[id];
    const bool is_of_two = is_binary(n.op);
    ++users_[n.a];
    if (is_of_two) ++users_[n.b];
    if (active_[n.a] == 0 && (!is_of_two || active_[n.b] == 0)) return;
    active_[id] = 1;
    const int own = id * words_, first = n.a * words_, second = n.b * words_;
    word* const all = depends_ + own;
    const word *const a = depends_ + first, *const b = depends_ + second;
    for (int w = 0; w < words_; ++w) all[w] = is_of_two ? a[w] | b[w] : a[w];
  }

  /// Counts operations for each symbol on which `a` depends or, if b is given, on which both depend.
  constexpr void charge(int a, int b = -1) {
    if (active_[a] == 0 || (b >= 0 && active_[b] == 0)) return;
    const word* const of = depends_;
    int* const charged = forward_.begin();
    for (int w = 0; w < words_; ++w) {
      word left = of[a * words_ + w];
      if (b >= 0) left &= of[b * words_ + w];
      for (; left != 0; left &= left - 1) ++charged[64 * w + std::countr_zero(left)];
    }
  }
  /// Counts a product with the rate of an operand; the rate of a symbol is 1.
  constexpr void charge_product(int operand) {
    if (nodes_[operand].op != operation::symbol) charge(operand);
  }

  constexpr void count_forward(const graph& g) {
    base::zeros<char> of_within(size_); // a product that belongs to one rotated component only
    char* const is_within = of_within.begin();
    for (int id = size_ - 1; id >= 0; --id) {
      if (active_[id] == 0 || live_[id] == 0 || is_held_[id] != 0 || is_within[id] != 0) continue;
      const node& n = nodes_[id];
      if (n.op <= operation::symbol) continue; // a leaf
      if (const rotated_component x = rotated_component_at(g, n)) {
        if (users_[n.a] == 1) is_within[n.a] = 1;
        if (users_[n.b] == 1) is_within[n.b] = 1;
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

  constexpr void count_reverse(const graph& g, const sequence<int>& outputs) {
    const int words = (outputs.size() + 63) / 64;
    base::zeros<word> of_reached(size_ * words);
    base::zeros<char> of_unit(size_);
    word* const reached = of_reached.begin(); // the outputs that depend on each node
    char* const is_unit = of_unit.begin();    // whether the adjoint is 1 or −1
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
    for (int id = size_ - 1; id >= 0; --id) {
      if (active_[id] == 0 || live_[id] == 0) continue;
      int count = 0;
      for (int w = 0; w < words; ++w) count += std::popcount(reached[id * words + w]);
      reverse_[id] -= count; // the first of several parts of an adjoint is not added to anything
      const node& n = nodes_[id];
      if (n.op <= operation::symbol || is_held_[id] != 0 || count == 0) continue;
      if (const rotated_component x = rotated_component_at(g, n); x && users_[n.a] == 1 && users_[n.b] == 1) {
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
      const word *const of = depends_, *const still = remaining.begin();
      const char* const active = active_;
      for (int id = 0, end = size_; id < end; ++id) {
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

  const node* nodes_;
  int size_, symbols_, words_;
  base::zeros<char> of_live_;
  base::zeros<word> of_depends_;
  base::zeros<char> of_active_;
  base::zeros<int> of_users_, of_reverse_;
  base::zeros<char> of_held_;
  sequence<int> forward_;     ///< the operations for each symbol
  sequence<char> is_forward_; ///< by symbol
  // for each node, as pointers, because compilers interpret every call
  const char* live_;
  char* active_;  ///< whether it depends on any symbol
  char* is_held_; ///< whether it counts as a constant
  word* depends_; ///< the symbols on which it depends, as bits
  int* users_;    ///< the number of its users
  int* reverse_;  ///< the operations for its adjoint
  int all_forward_ = 0, mixed_ = 0;
};

} // namespace kanexpr::symbolic
