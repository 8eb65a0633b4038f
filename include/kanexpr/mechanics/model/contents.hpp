#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <string_view>

namespace kanexpr::mechanics {

/// The kinds of symbols in the expressions of a graph, and whether the expressions look linear in speeds and
/// coordinate rates; determined for the whole graph in one pass.
class contents {
public:
  using kind = symbolic::symbol_kind;

  constexpr explicit contents(const graph& g) : g_(g), held_(g.size(), 0) {
    for (int id = 0; id < g.size(); ++id) held_[id] = of(g[id], id);
  }

  constexpr bool holds(expression e, kind wanted) const { return (held_[e.node()] & bit_of(wanted)) != 0; }
  constexpr bool holds_any(expression e, std::initializer_list<kind> wanted) const {
    for (kind k : wanted)
      if (holds(e, k)) return true;
    return false;
  }

  /// Whether an expression contains only numbers and parameters.
  constexpr bool is_fixed(expression e) const {
    return (held_[e.node()] & ~(bit_of(kind::parameter) | nonlinear)) == 0;
  }
  constexpr bool is_fixed(const components& v) const {
    return is_fixed(v.x) && is_fixed(v.y) && is_fixed(v.z);
  }
  constexpr bool is_fixed(const matrix3& m) const {
    return is_fixed(m.row[0]) && is_fixed(m.row[1]) && is_fixed(m.row[2]);
  }

  /// Whether the orientation of a frame in its parent contains only numbers and parameters.
  constexpr bool is_fixed(const frame& f) const {
    return f.kind == orientation::matrix ? is_fixed(f.to_parent) : is_fixed(f.angle);
  }

  /// Whether an expression looks linear: false if it contains a product, quotient or function of speeds or
  /// rates, even if these terms cancel.
  constexpr bool looks_linear(expression e) const { return (held_[e.node()] & nonlinear) == 0; }

  /// The name of the first symbol of a given kind in the expression.
  constexpr std::string_view name_of(expression e, kind wanted) const {
    int id = e.node();
    while (g_[id].op != symbolic::operation::symbol) {
      const symbolic::node& n = g_[id];
      id = (held_[n.a] & bit_of(wanted)) != 0 ? n.a : n.b;
    }
    return g_.symbol_at(id).called.view();
  }

  /// Adds the symbols of a given kind in the expression.
  constexpr void collect(expression e, kind wanted, sequence<int>& nodes) const {
    collect(e.node(), wanted, nodes);
  }

  /// The symbols of the given kinds in an expression or a vector.
  constexpr sequence<int> symbols_in(expression e, std::initializer_list<kind> wanted) const {
    sequence<int> nodes;
    for (const kind k : wanted) collect(e.node(), k, nodes);
    return nodes;
  }
  constexpr sequence<int> symbols_in(const vector& v, std::initializer_list<kind> wanted) const {
    sequence<int> nodes;
    v.each_entry([&](expression e) {
      for (const kind k : wanted) collect(e.node(), k, nodes);
    });
    return nodes;
  }

private:
  static constexpr unsigned nonlinear = 1u << 31;
  static constexpr unsigned moving = 1u << static_cast<int>(kind::speed) |
                                     1u << static_cast<int>(kind::coordinate_rate) |
                                     1u << static_cast<int>(kind::auxiliary_speed);
  static constexpr unsigned bit_of(kind k) { return 1u << static_cast<int>(k); }

  constexpr unsigned of(const symbolic::node& n, int id) const {
    using symbolic::operation;
    if (n.op == operation::constant) return 0;
    if (n.op == operation::symbol) return bit_of(g_.symbol_at(id).kind);
    const unsigned a = held_[n.a], b = symbolic::is_binary(n.op) ? held_[n.b] : 0;
    bool linear = true;
    if (n.op == operation::multiply)
      linear = (a & moving) == 0 || (b & moving) == 0;
    else if (n.op == operation::divide)
      linear = (b & moving) == 0;
    else if (n.op != operation::negate && n.op != operation::add && n.op != operation::subtract)
      linear = ((a | b) & moving) == 0;
    return a | b | (linear ? 0 : nonlinear);
  }

  constexpr void collect(int id, kind wanted, sequence<int>& nodes) const {
    if ((held_[id] & bit_of(wanted)) == 0) return;
    const symbolic::node& n = g_[id];
    if (n.op == symbolic::operation::symbol) {
      if (!nodes.contains(id)) nodes.push(id);
      return;
    }
    collect(n.a, wanted, nodes);
    if (symbolic::is_binary(n.op)) collect(n.b, wanted, nodes);
  }

  const graph& g_;
  sequence<unsigned> held_;
};

} // namespace kanexpr::mechanics
