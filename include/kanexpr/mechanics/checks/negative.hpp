#pragma once

#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/function_table.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

namespace kanexpr::mechanics {

namespace detail {

/// Whether a node is positive for positive parameters; handles sums, products, quotients, powers and the
/// like.
constexpr bool is_positive(const symbolic::graph& g, int id) {
  using symbolic::form;
  const symbolic::node& n = g[id];
  switch (symbolic::form_of(n.op)) {
  case form::leaf:
    return g.is_constant(id) ? g.number_at(id).value() > 0
                             : g.symbol_at(id).kind == symbolic::symbol_kind::parameter;
  case form::add:
  case form::multiply:
  case form::divide: return is_positive(g, n.a) && (n.a == n.b || is_positive(g, n.b));
  case form::power: return is_positive(g, n.a);
  case form::function: return symbolic::properties_of(n.op).never_negative;
  case form::negate:
  case form::subtract:
  case form::binary_function:
  case form::selection:
  case form::list_operation: break;
  }
  return false;
}

} // namespace detail

/// Whether a scalar is negative as a number, or for all positive parameters, such as -2*m.
constexpr bool is_negative(symbolic::expression e) {
  const symbolic::graph& g = e.owner();
  if (e.is_constant()) return g.number_at(e.node()).negative();
  const symbolic::node& n = g[e.node()];
  return n.op == symbolic::operation::negate && detail::is_positive(g, n.a);
}

} // namespace kanexpr::mechanics
