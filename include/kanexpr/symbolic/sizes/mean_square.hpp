#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/base/zeros.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/graph/rules.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>
#include <kanexpr/symbolic/sizes/equal_units.hpp>

/// The size of an expression if nothing cancels: the reference for judging whether it is zero.
namespace kanexpr::symbolic {

/// The mean square of expressions over all angles, as if all sines and cosines were independent: each of them
/// contributes 1/2, a sum has the sum of the mean squares of its terms, and a product has the product of
/// those of its factors. The result has the unit of the squared expression, is invariant under rotations of
/// axes, and does not vanish where sines and cosines vanish or terms cancel. Other functions, divisors and
/// symbols contribute the squares of their values.
///
/// Coordinates that are not angles, and speeds, may vanish where an equation vanishes. Each contributes the
/// mean square of all such symbols of the same unit in the equations, some of which are usually nonzero:
/// (x² + y²)/2 for x as well as for y, as if the axes could be rotated. Units are inferred from the fact that
/// all terms of a sum have the same unit: both the sums in the equations and the `sums` from which the
/// equations were formed are used.
class mean_square {
public:
  constexpr mean_square(graph& g, const sequence<int>& equations, const sequence<int>& expressions,
                        const sequence<int>& sums)
      : g_(g), squares_(g.size()) {
    const sequence<int> all = terms_of(equations), needed = terms_of(expressions);
    sequence<int> variables;
    for (int id : all)
      if (is_variable(id)) variables.push(id);
    if (!variables.empty()) average_over_same_unit(variables, equations, sums);
    for (int id : needed)
      if (squares_[id] == graph::zero) squares_[id] = square(id);
  }

  /// The mean square of one of the expressions.
  constexpr int operator[](int expression) const { return squares_[expression]; }

private:
  constexpr bool is_variable(int id) const {
    if (g_[id].op != operation::symbol) return false;
    const symbol_kind kind = g_.symbol_at(id).kind;
    return kind == symbol_kind::coordinate || kind == symbol_kind::speed;
  }

  constexpr void average_over_same_unit(const sequence<int>& variables, sequence<int> sums,
                                        const sequence<int>& more) {
    for (int id : more) sums.push(id);
    if (variables.size() == 1) sums.clear(); // there is only one
    const equal_units found(g_, sums);
    for (int one : variables) {
      int total = graph::zero, count = 0;
      for (int other : variables)
        if (one == other || found.have_same_unit(one, other))
          total = add(g_, total, multiply(g_, other, other)), ++count;
      squares_[one] = multiply(g_, g_.constant(exactly(1, count)), total);
    }
  }

  /// The sums and products in expressions, with their operands, in ascending order.
  constexpr sequence<int> terms_of(const sequence<int>& expressions) const {
    base::zeros<char> marks(g_.size());
    char* const reached = marks.begin();
    const node* const nodes = g_.begin();
    int last = -1;
    for (int id : expressions) {
      reached[id] = 1;
      if (id > last) last = id;
    }
    for (int id = last; id >= 0; --id) {
      if (reached[id] == 0) continue;
      const node& n = nodes[id];
      if (n.op < operation::negate || n.op > operation::divide) continue;
      reached[n.a] = 1;
      if (n.op != operation::negate && n.op != operation::divide) reached[n.b] = 1;
    }
    sequence<int> terms;
    for (int id = 0; id <= last; ++id)
      if (reached[id] != 0) terms.push(id);
    return terms;
  }

  constexpr int square(int id) {
    const node n = g_[id];
    if (n.op == operation::negate) return squares_[n.a];
    if (n.op == operation::add || n.op == operation::subtract) return add(g_, squares_[n.a], squares_[n.b]);
    if (n.op == operation::multiply) return multiply(g_, squares_[n.a], squares_[n.b]);
    if (n.op == operation::divide) return divide(g_, squares_[n.a], multiply(g_, n.b, n.b));
    if (n.op == operation::sin || n.op == operation::cos) return g_.constant(exactly(1, 2));
    return multiply(g_, id, id);
  }

  graph& g_;
  base::zeros<int> squares_; ///< by node
};

/// The mean square of a determinant: the permanent of the mean squares of its entries, which are given row by
/// row.
constexpr int permanent(graph& g, const sequence<int>& squares, int order) {
  if (order == 1) return squares[0];
  int sum = graph::zero;
  for (int j = 0; j < order; ++j) {
    sequence<int> rest;
    for (int i = 1; i < order; ++i)
      for (int k = 0; k < order; ++k)
        if (k != j) rest.push(squares[i * order + k]);
    sum = add(g, sum, multiply(g, squares[j], permanent(g, rest, order - 1)));
  }
  return sum;
}

} // namespace kanexpr::symbolic
