#pragma once

#include <kanexpr/symbolic/graph/rules.hpp>
#include <kanexpr/symbolic/graph/solve_rules.hpp>

namespace kanexpr::symbolic {

/// Any operation on nodes that exist, simplified.
constexpr int build(graph& g, operation op, int a, int b) {
  switch (op) {
  case operation::negate: return negate(g, a);
  case operation::add: return add(g, a, b);
  case operation::subtract: return subtract(g, a, b);
  case operation::multiply: return multiply(g, a, b);
  case operation::divide: return divide(g, a, b);
  case operation::power: return power(g, a, b);
  case operation::atan2: return atan2(g, a, b);
  case operation::pair:
  case operation::factorization: return g.find_or_append({op, a, b});
  case operation::solve:
  case operation::transposed_solve: return solution(g, op, a, b);
  case operation::component: return component(g, a, integer_at(g, b));
  case operation::regularity: return regularity(g, a, b);
  default: return apply(g, op, a);
  }
}

} // namespace kanexpr::symbolic
