#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/list.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/graph/rules.hpp>
#include <kanexpr/symbolic/numbers/number.hpp>

/// Builds the nodes of all operations, including linear systems: a system of order one becomes a division,
/// and a constant system is solved immediately; all others stay symbolic until lowering, when the required
/// components are known.
namespace kanexpr::symbolic {

/// The factorization of a matrix whose entries are given row by row.
constexpr int factorization(graph& g, const sequence<int>& entries, int order) {
  sequence<int> rows;
  for (int i = 0; i < order; ++i) {
    sequence<int> row;
    for (int j = 0; j < order; ++j) row.push(entries[i * order + j]);
    rows.push(list_of(g, row));
  }
  return g.find_or_append({operation::factorization, list_of(g, rows), g.constant(exactly(order))});
}

/// Inverts a matrix of numbers stored in row-major order, exactly if they are fractions. Returns an empty
/// sequence if the matrix is singular.
constexpr sequence<number> inverse_of(sequence<number> a, int order) {
  sequence<number> inverse(order * order, exactly(0));
  for (int i = 0; i < order; ++i) inverse[i * order + i] = exactly(1);
  const auto magnitude = [](const number& n) { return n.negative() ? -n.value() : n.value(); };
  const auto subtract_row = [&](sequence<number>& m, int from, int row, const number& weight) {
    for (int j = 0; j < order; ++j) m[from * order + j] = m[from * order + j] - weight * m[row * order + j];
  };
  for (int k = 0; k < order; ++k) {
    int pivot = k;
    for (int i = k + 1; i < order; ++i)
      if (magnitude(a[i * order + k]) > magnitude(a[pivot * order + k])) pivot = i;
    if (base::equal(magnitude(a[pivot * order + k]), 0.0)) return {};
    const number below = a[pivot * order + k];
    for (sequence<number>* m : {&a, &inverse})
      for (int j = 0; j < order; ++j) {
        const number lifted = (*m)[pivot * order + j] / below;
        (*m)[pivot * order + j] = (*m)[k * order + j];
        (*m)[k * order + j] = lifted;
      }
    for (int i = 0; i < order; ++i) {
      const number weight = a[i * order + k];
      if (i == k || base::equal(magnitude(weight), 0.0)) continue;
      subtract_row(a, i, k, weight);
      subtract_row(inverse, i, k, weight);
    }
  }
  return inverse;
}

/// The inverse of a factorized matrix of constants, row by row; empty if the matrix is singular or not
/// constant.
constexpr sequence<number> constant_inverse(const graph& g, int factorization) {
  sequence<number> entries;
  for (int entry : entries_of(g, factorization)) {
    if (!g.is_constant(entry)) return {};
    entries.push(g.number_at(entry));
  }
  return inverse_of(entries, order_of(g, factorization));
}

/// The complete solution of a system; zero if the right-hand side is zero.
constexpr int solution(graph& g, operation op, int factorization, int right) {
  bool is_zero = true;
  for (int list = right; g[list].op == operation::pair; list = g[list].b)
    is_zero = is_zero && g[list].a == graph::zero;
  return is_zero ? graph::zero : g.find_or_append({op, factorization, right});
}

constexpr int component(graph& g, int solution, int index) {
  if (solution == graph::zero) return graph::zero;
  const node n = g[solution];
  if (n.op == operation::symmetric_solve)
    return g.find_or_append({operation::component, solution, g.constant(exactly(index))});
  const int order = order_of(g, n.a);
  const sequence<int> right = elements_of(g, n.b);
  if (order == 1) return divide(g, right[0], entries_of(g, n.a)[0]);
  bool is_constant = true;
  for (int id : right) is_constant = is_constant && g.is_constant(id);
  if (is_constant) {
    const sequence<number> inverse = constant_inverse(g, n.a);
    number sum = exactly(0);
    for (int j = 0; j < order && !inverse.empty(); ++j) {
      const int place = n.op == operation::solve ? index * order + j : j * order + index;
      sum = sum + inverse[place] * g.number_at(right[j]);
    }
    if (!inverse.empty()) return g.constant(sum);
  }
  return g.find_or_append({operation::component, solution, g.constant(exactly(index))});
}

constexpr int singularity_measure(graph& g, int factorization, int squares) {
  if (order_of(g, factorization) == 1) return apply(g, operation::abs, entries_of(g, factorization)[0]);
  bool is_constant = true;
  for (int id : entries_of(g, factorization)) is_constant = is_constant && g.is_constant(id);
  if (is_constant && constant_inverse(g, factorization).empty()) return graph::zero;
  return g.find_or_append({operation::singularity_measure, factorization, squares});
}

/// Applies an operation to existing nodes and simplifies the result.
constexpr int build(graph& g, operation op, int a, int b) {
  switch (form_of(op)) {
  case form::negate: return negate(g, a);
  case form::add: return add(g, a, b);
  case form::subtract: return subtract(g, a, b);
  case form::multiply: return multiply(g, a, b);
  case form::divide: return divide(g, a, b);
  case form::power: return power(g, a, b);
  case form::function: return apply(g, op, a);
  case form::binary_function: return apply(g, op, a, b);
  case form::selection: return selected(g, op, a, b);
  case form::list_operation:
    if (is_solution(op)) return solution(g, op, a, b);
    if (op == operation::component) return component(g, a, integer_at(g, b));
    if (op == operation::singularity_measure) return singularity_measure(g, a, b);
    return g.find_or_append({op, a, b});
  case form::leaf: break; // no operands
  }
  return graph::zero;
}

} // namespace kanexpr::symbolic
