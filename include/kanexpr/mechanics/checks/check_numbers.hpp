#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

/// Expressions without a finite value, such as a division by zero.
namespace kanexpr::mechanics {

/// Whether a node is a constant that is not finite, or divides by the constant zero.
constexpr bool has_no_value(const symbolic::graph& g, int id) {
  const symbolic::node& n = g[id];
  if (n.op == symbolic::operation::divide) return n.b == symbolic::graph::zero;
  return n.op == symbolic::operation::constant && !symbolic::is_finite(g.number_at(id));
}

/// Determines which expressions of a growing graph contain a number that is not finite; visits each node
/// once.
class finiteness {
public:
  constexpr bool holds_no_number(symbolic::expression e) {
    const symbolic::graph& g = e.owner();
    for (int id = without_value_.size(); id <= e.node(); ++id) {
      const symbolic::node& n = g[id];
      const bool inside =
          !symbolic::is_leaf(n.op) &&
          (without_value_[n.a] != 0 || (symbolic::is_binary(n.op) && without_value_[n.b] != 0));
      without_value_.push(inside || has_no_value(g, id) ? 1 : 0);
    }
    return without_value_[e.node()] != 0;
  }

private:
  base::sequence<char> without_value_{};
};

} // namespace kanexpr::mechanics
