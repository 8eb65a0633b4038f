#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/base/zeros.hpp>
#include <kanexpr/numeric/symmetric_columns.hpp>
#include <kanexpr/symbolic/graph/function_table.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/linear/expand_solves.hpp>
#include <kanexpr/symbolic/linear/symmetric_columns.hpp>
#include <kanexpr/symbolic/operation_weights.hpp>

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
  int nodes = 0;        ///< all operations, including signs but not inputs and constants
  int square_roots = 0; ///< the part of `other` that are square roots
  int fused = 0;        ///< the sums that can be evaluated together with a product, which nothing else uses

  constexpr bool operator==(const cost&) const = default;

  /// The cost on a target.
  constexpr long long weighted(const operation_weights& by) const {
    const long long plain = 1LL * by.multiplication * (multiplications - fused) +
                            1LL * by.addition * (additions - fused) + 1LL * by.fused * fused;
    return plain + 1LL * by.division * divisions + 1LL * by.square_root * square_roots +
           1LL * by.trigonometric * trigonometric + 1LL * by.other * (other - square_roots);
  }

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
    case form::function:
      (properties_of(op).is_trigonometric ? trigonometric : other) += times;
      if (op == operation::sqrt) square_roots += times;
      break;
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
    fused += updates;
  }
  constexpr void count_substitution(int order) {
    count(order * order, order * (order - 1), 0);
    fused += order * (order - 1);
  }
  /// Signs are free.
  constexpr void count_columns(const numeric::column_steps& steps, int columns) {
    int products = 0, sums = 0;
    for (const numeric::column_step& s : steps.all) {
      ++products;
      if (!s.is_pivot() && !s.fills) ++sums;
    }
    count(columns * products, columns * sums, 0);
    fused += columns * sums;
  }
  constexpr void count_singularity_measure(int order) {
    const int updates = (order - 1) * order * (2 * order - 1) / 6;
    count(2 * order + order * (order - 1) / 2 + updates, updates + order - 1, 1);
    fused += updates;
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

/// How often each live node is used.
template <class Nodes, class List, class Uses>
constexpr void count_uses(const Nodes& nodes, const List& live, Uses& uses, int count) {
  for (int i = 0; i < count; ++i) {
    const int id = live[i];
    const operation op = nodes[id].op;
    if (op <= operation::symbol) continue; // a leaf
    ++uses[nodes[id].a];
    if (op <= operation::power ? op != operation::negate : is_binary(op) && !has_index_operand(op))
      ++uses[nodes[id].b];
  }
}

constexpr void count_columns(const graph& g, const node& n, cost& total) {
  const symmetric_columns system(g, n);
  total.count_columns(system.steps(), system.columns);
}

template <bool is_constant>
constexpr cost cost_of_written_out(const graph& g, const sequence<int>& outputs, const live_list& needed) {
  base::zeros<int> uses(g.size());
  const auto& nodes = g.elements<is_constant>();
  const auto& live = needed.nodes.elements<is_constant>();
  auto& use = uses.elements<is_constant>();
  count_uses(nodes, live, use, needed.count);
  for (int id : outputs) ++use[id];
  cost total;
  int products = 0, sums = 0, signs = 0, fused = 0; // most operations
  for (int i = 0; i < needed.count; ++i) {
    const int id = live[i];
    const operation op = nodes[id].op;
    if (op <= operation::symbol) continue; // a leaf
    if (op == operation::multiply) {
      ++products;
      continue;
    }
    if (op == operation::add || op == operation::subtract) {
      ++sums;
      const int a = nodes[id].a, b = nodes[id].b;
      if ((nodes[a].op == operation::multiply && use[a] == 1) ||
          (nodes[b].op == operation::multiply && use[b] == 1))
        ++fused; // with a product that nothing else uses
      continue;
    }
    if (op == operation::negate) {
      ++signs;
      continue;
    }
    const node n = nodes[id];
    if (n.op < operation::pair || n.op == operation::call)
      total.count(n.op);
    else if (n.op == operation::factorization)
      total.count_factorization(order_of(g, id));
    else if (is_solution(n.op))
      total.count_substitution(order_of(g, n.a));
    else if (n.op == operation::symmetric_solve)
      count_columns(g, n, total);
    else if (n.op == operation::singularity_measure)
      total.count_singularity_measure(order_of(g, n.a));
    if (n.op != operation::cos) continue;
    const int sine = g.find({operation::sin, n.a, 0});
    if (sine >= 0 && needed.marks[sine] != 0) --total.trigonometric;
  }
  total.count(operation::multiply, products);
  total.count(operation::add, sums);
  total.count(operation::negate, signs);
  total.fused += fused;
  return total;
}
constexpr cost cost_of_written_out(const graph& g, const sequence<int>& outputs, const live_list& live) {
  return __builtin_is_constant_evaluated() ? cost_of_written_out<true>(g, outputs, live)
                                           : cost_of_written_out<false>(g, outputs, live);
}

} // namespace detail

/// The cost of the outputs after lowering: small linear systems are expanded, large ones use elimination.
constexpr cost cost_of(const graph& g, const sequence<int>& outputs) {
  const live_list live(g, outputs);
  if (!has_linear_systems(g, live)) return detail::cost_of_written_out(g, outputs, live);
  graph copy = g;
  const sequence<int> expanded = expand_solves(copy, outputs, live);
  return detail::cost_of_written_out(copy, expanded, live_list(copy, expanded));
}

/// Returns `total` plus `times` times the cost c.
constexpr cost added(cost total, const cost& c, int times = 1) {
  total.multiplications += times * c.multiplications;
  total.additions += times * c.additions;
  total.divisions += times * c.divisions;
  total.trigonometric += times * c.trigonometric;
  total.other += times * c.other;
  total.nodes += times * c.nodes;
  total.square_roots += times * c.square_roots;
  total.fused += times * c.fused;
  return total;
}

} // namespace kanexpr::symbolic
