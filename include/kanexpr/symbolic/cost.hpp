#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/function_table.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/linear/expand_solves.hpp>

namespace kanexpr::symbolic {

/// The operation counts of one evaluation. Subtractions count as additions, a square as one multiplication;
/// signs are free; the sine and cosine of one angle count as one trigonometric call. `other` counts the
/// remaining functions.
struct cost {
  int multiplications = 0;
  int additions = 0;
  int divisions = 0;
  int trigonometric = 0;
  int other = 0;
  int nodes = 0; ///< all operations, including signs but not inputs and constants

  constexpr bool operator==(const cost&) const = default;

  constexpr void count(operation op, int times = 1) {
    nodes += times;
    switch (form_of(op)) {
    case form::leaf:
    case form::negate: break;
    case form::selection: // a comparison
    case form::add:
    case form::subtract: additions += times; break;
    case form::multiply: multiplications += times; break;
    case form::divide: divisions += times; break;
    case form::function: (properties_of(op).is_trigonometric ? trigonometric : other) += times; break;
    case form::binary_function:
      (binary_properties_of(op).is_trigonometric ? trigonometric : other) += times;
      break;
    case form::power: other += times; break;
    case form::list_operation:
      if (op == operation::call) other += times; // linear systems are counted by their order
      break;
    }
  }

  /// The cost of an elimination: signs and selections are free, a comparison counts as a subtraction.
  constexpr void count_factorization(int order) {
    const int comparisons = order * (order - 1) / 2, updates = (order - 1) * order * (2 * order - 1) / 6;
    count(comparisons + updates, comparisons + updates, order); // a multiplier is a product
  }
  constexpr void count_substitution(int order) { count(order * order, order * (order - 1), 0); }
  constexpr void count_singularity_measure(int order) {
    const int updates = (order - 1) * order * (2 * order - 1) / 6;
    count(2 * order + order * (order - 1) / 2 + updates, updates + order - 1, 1);
    count(operation::sqrt);
  }

private:
  constexpr void count(int products, int sums, int quotients) {
    multiplications += products;
    additions += sums;
    divisions += quotients;
    nodes += products + sums + quotients;
  }
};

namespace detail {

constexpr cost cost_of_written_out(const graph& g, const sequence<int>& outputs) {
  const sequence<char> live = live_nodes(g, outputs);
  cost total;
  for (int id = 0; id < g.size(); ++id) {
    const node& n = g[id];
    if (live[id] == 0 || is_leaf(n.op)) continue;
    if (n.op < operation::pair || n.op == operation::call)
      total.count(n.op);
    else if (n.op == operation::factorization)
      total.count_factorization(order_of(g, id));
    else if (is_solution(n.op))
      total.count_substitution(order_of(g, n.a));
    else if (n.op == operation::singularity_measure)
      total.count_singularity_measure(order_of(g, n.a));
    if (n.op != operation::cos) continue;
    const int sine = g.find({operation::sin, n.a, 0});
    if (sine >= 0 && live[sine] != 0) --total.trigonometric;
  }
  return total;
}

} // namespace detail

/// The cost of the outputs after lowering: small linear systems are expanded, large ones use elimination.
constexpr cost cost_of(const graph& g, const sequence<int>& outputs) {
  if (!has_linear_systems(g, live_nodes(g, outputs))) return detail::cost_of_written_out(g, outputs);
  graph copy = g;
  const sequence<int> expanded = expand_solves(copy, outputs);
  return detail::cost_of_written_out(copy, expanded);
}

/// Returns `total` plus `times` times the cost c.
constexpr cost added(cost total, const cost& c, int times = 1) {
  total.multiplications += times * c.multiplications;
  total.additions += times * c.additions;
  total.divisions += times * c.divisions;
  total.trigonometric += times * c.trigonometric;
  total.other += times * c.other;
  total.nodes += times * c.nodes;
  return total;
}

} // namespace kanexpr::symbolic
