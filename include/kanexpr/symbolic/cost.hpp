#pragma once

#include <kanexpr/symbolic/linear/expand_solves.hpp>

namespace kanexpr::symbolic {

/// What one evaluation does. Subtractions count as additions, a square as one multiplication; signs are free;
/// the sine and cosine of one angle are one trigonometric call. `other` are the remaining functions.
struct cost {
  int multiplications = 0;
  int additions = 0;
  int divisions = 0;
  int trigonometric = 0;
  int other = 0;
  int nodes = 0; ///< all operations, signs included; inputs and constants not

  constexpr bool operator==(const cost&) const = default;

  constexpr void count(operation op) {
    ++nodes;
    switch (op) {
    case operation::constant:
    case operation::symbol:
    case operation::negate: break;
    case operation::add:
    case operation::subtract: ++additions; break;
    case operation::multiply: ++multiplications; break;
    case operation::divide: ++divisions; break;
    case operation::sin:
    case operation::cos:
    case operation::tan:
    case operation::asin:
    case operation::acos:
    case operation::atan:
    case operation::atan2: ++trigonometric; break;
    default: ++other; break;
    }
  }

  /// What is done by elimination: signs and selections are free, a comparison is a subtraction.
  constexpr void count_factorization(int order) {
    const int comparisons = order * (order - 1) / 2, updates = (order - 1) * order * (2 * order - 1) / 6;
    count(comparisons + updates, comparisons + updates, order); // a multiplier is a product
  }
  constexpr void count_substitution(int order) { count(order * order, order * (order - 1), 0); }
  constexpr void count_regularity(int order) {
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
    switch (n.op) {
    case operation::pair:
    case operation::component: break;
    case operation::factorization: total.count_factorization(order_of(g, id)); break;
    case operation::solve:
    case operation::transposed_solve: total.count_substitution(order_of(g, n.a)); break;
    case operation::regularity: total.count_regularity(order_of(g, n.a)); break;
    default: total.count(n.op); break;
    }
    if (n.op != operation::cos) continue;
    const int sine = g.find({operation::sin, n.a, 0});
    if (sine >= 0 && live[sine] != 0) --total.trigonometric;
  }
  return total;
}

} // namespace detail

/// What the outputs cost when they are lowered: small linear systems written out, large ones by elimination.
constexpr cost cost_of(const graph& g, const sequence<int>& outputs) {
  if (!holds_solves(g, live_nodes(g, outputs))) return detail::cost_of_written_out(g, outputs);
  graph copy = g;
  const sequence<int> expanded = expand_solves(copy, outputs);
  return detail::cost_of_written_out(copy, expanded);
}

} // namespace kanexpr::symbolic
