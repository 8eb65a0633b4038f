#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/external.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

/// Lists as nodes, so that a node with two operands can represent an operation on many values.
namespace kanexpr::symbolic {

constexpr int list_of(graph& g, const sequence<int>& elements) {
  int list = graph::zero;
  for (int i = elements.size() - 1; i >= 0; --i)
    list = g.find_or_append({operation::pair, elements[i], list});
  return list;
}

constexpr void append_elements(const graph& g, int list, sequence<int>& elements) {
  for (; g[list].op == operation::pair; list = g[list].b) elements.push(g[list].a);
}

constexpr sequence<int> elements_of(const graph& g, int list) {
  sequence<int> elements;
  append_elements(g, list, elements);
  return elements;
}

/// The elements of a list of rows, row by row.
constexpr sequence<int> elements_of_rows(const graph& g, int rows) {
  sequence<int> elements;
  for (; g[rows].op == operation::pair; rows = g[rows].b) append_elements(g, g[rows].a, elements);
  return elements;
}

/// An integer stored as an operand: an order or an index.
constexpr int integer_at(const graph& g, int constant) {
  return static_cast<int>(g.number_at(constant).numerator);
}

/// A call to a user-defined function with a list of operands.
constexpr int call(graph& g, const external_function& f, int operands) {
  sequence<const external_function*>& all = g.externals();
  int place = all.find(&f);
  if (place < 0) place = all.push(&f);
  return g.find_or_append({operation::call, operands, g.constant(exactly(place))});
}

/// Systems up to this order are expanded by cofactors when they are lowered.
inline constexpr int max_cofactor_order = 3;

constexpr int order_of(const graph& g, int factorization) { return integer_at(g, g[factorization].b); }

/// The entries of a factorized matrix, row by row.
constexpr sequence<int> entries_of(const graph& g, int factorization) {
  return elements_of_rows(g, g[factorization].a);
}

} // namespace kanexpr::symbolic
