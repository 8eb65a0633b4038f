#pragma once

#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::mechanics {

namespace detail {

/// Whether a node is positive wherever parameters are: of sums, products, quotients, powers and the like.
constexpr bool is_positive(const symbolic::graph& g, int id) {
  using symbolic::operation;
  const symbolic::node& n = g[id];
  switch (n.op) {
  case operation::constant: return g.number_at(id).value() > 0;
  case operation::symbol: return g.symbol_at(id).kind == symbolic::symbol_kind::parameter;
  case operation::add:
  case operation::multiply:
  case operation::divide: return is_positive(g, n.a) && (n.a == n.b || is_positive(g, n.b));
  case operation::sqrt:
  case operation::power: return is_positive(g, n.a);
  case operation::exp:
  case operation::abs: return true;
  default: return false;
  }
}

} // namespace detail

/// Whether a scalar is negative: as a number, or wherever its parameters are positive, as -2*m.
constexpr bool is_negative(symbolic::expression e) {
  const symbolic::graph& g = e.owner();
  if (e.is_constant()) return g.number_at(e.node()).negative();
  const symbolic::node& n = g[e.node()];
  return n.op == symbolic::operation::negate && detail::is_positive(g, n.a);
}

} // namespace kanexpr::mechanics
