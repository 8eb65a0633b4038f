#pragma once

#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/rules.hpp>
#include <kanexpr/symbolic/graph/solve_rules.hpp>

namespace kanexpr::symbolic {

/// Applies an operation to existing nodes and simplifies the result.
constexpr int build(graph& g, operation op, int a, int b) {
  switch (form_of(op)) {
  case form::negate: return negate(g, a);
  case form::add: return add(g, a, b);
  case form::subtract: return subtract(g, a, b);
  case form::multiply: return multiply(g, a, b);
  case form::divide: return divide(g, a, b);
  case form::power: return power(g, a, b);
  case form::binary_function: return apply(g, op, a, b);
  case form::selection: return selected(g, op, a, b);
  case form::pair:
  case form::factorization:
  case form::call: return g.find_or_append({op, a, b});
  case form::solve:
  case form::transposed_solve: return solution(g, op, a, b);
  case form::component: return component(g, a, integer_at(g, b));
  case form::singularity_measure: return singularity_measure(g, a, b);
  case form::function: return apply(g, op, a);
  case form::constant:
  case form::symbol: break; // no operands
  }
  return graph::zero;
}

} // namespace kanexpr::symbolic
