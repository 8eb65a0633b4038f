#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

namespace kanexpr::mechanics {

namespace detail {

constexpr bool is_fixed(const graph& g, int id, sequence<char>& seen) {
  if (seen[id] != 0) return true; // visited already
  seen[id] = 1;
  const symbolic::node& n = g[id];
  if (n.op == symbolic::operation::constant) return true;
  if (n.op == symbolic::operation::symbol) return g.symbol_at(id).kind == symbolic::symbol_kind::parameter;
  return is_fixed(g, n.a, seen) && (!symbolic::is_binary(n.op) || is_fixed(g, n.b, seen));
}

} // namespace detail

/// Whether a scalar contains only numbers and parameters, and is therefore constant while the system moves.
constexpr bool is_fixed(expression e) {
  if (e.is_constant()) return true;
  sequence<char> seen(e.node() + 1, 0);
  return detail::is_fixed(e.owner(), e.node(), seen);
}

constexpr bool is_fixed(const components& v) { return is_fixed(v.x) && is_fixed(v.y) && is_fixed(v.z); }

} // namespace kanexpr::mechanics
