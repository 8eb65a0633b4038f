#pragma once

#include <kanexpr/mechanics/mechanism.hpp>

namespace kanexpr::mechanics {

/// Which symbols an expression holds; each node is looked at once.
class dependence {
public:
  constexpr explicit dependence(expression in) : g_(in.owner()), seen_(in.node() + 1, 0) { mark(in.node()); }

  constexpr bool on(expression symbol) const {
    return symbol.node() < seen_.size() && seen_[symbol.node()] != 0;
  }

  /// The first of some symbols that the expression holds, or none.
  constexpr int first_of(const sequence<expression>& symbols) const {
    for (int i = 0; i < symbols.size(); ++i)
      if (on(symbols[i])) return i;
    return none;
  }

  /// Whether it is made of numbers and parameters alone, so that it stays as it is while the system moves.
  constexpr bool on_nothing_that_changes() const {
    for (int id = 0; id < seen_.size(); ++id)
      if (seen_[id] != 0 && g_[id].op == symbolic::operation::symbol &&
          g_.symbol_at(id).kind != symbolic::symbol_kind::parameter)
        return false;
    return true;
  }

private:
  constexpr void mark(int id) {
    if (seen_[id] != 0) return;
    seen_[id] = 1;
    const symbolic::node& n = g_[id];
    if (symbolic::is_leaf(n.op)) return;
    mark(n.a);
    if (symbolic::is_binary(n.op)) mark(n.b);
  }

  const graph& g_;
  sequence<char> seen_;
};

constexpr bool is_fixed(expression e) { return e.is_constant() || dependence(e).on_nothing_that_changes(); }

constexpr bool is_fixed(const components& v) { return is_fixed(v.x) && is_fixed(v.y) && is_fixed(v.z); }

} // namespace kanexpr::mechanics
