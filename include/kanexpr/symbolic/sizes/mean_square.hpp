#pragma once

#include <kanexpr/symbolic/graph/matrix.hpp>
#include <kanexpr/symbolic/graph/rules.hpp>
#include <kanexpr/symbolic/sizes/units.hpp>

/// How large an expression is where nothing cancels: what it is compared with before it is called zero.
namespace kanexpr::symbolic {

/// The mean square of expressions over all angles, as if no two sines or cosines had to do with each other:
/// those have 1/2, a sum has the sum of its terms', a product the product of its factors'. So it has the
/// square of the expression's unit, turns of axes leave it what it is, and it does not vanish where sines and
/// cosines do or where terms cancel. Other functions, divisors and symbols count with their values.
///
/// Coordinates outside of angles may vanish where an equation does; they count with the mean square of all
/// such coordinates of their unit in the equations that the expressions stand in, of which usually some are
/// left: (x² + y²)/2 for each of x and y, as if these could turn. Which have one unit, sums tell: those in
/// the equations and `sums` that they come from.
class mean_square {
public:
  constexpr mean_square(graph& g, const sequence<int>& equations, const sequence<int>& expressions,
                        const sequence<int>& sums)
      : g_(g), squares_(g.size(), graph::zero) {
    const sequence<int> all = terms_of(equations), needed = terms_of(expressions);
    sequence<int> coordinates;
    for (int id : all)
      if (is_coordinate(id)) coordinates.push(id);
    if (!coordinates.empty()) count_with_their_like(coordinates, equations, sums);
    for (int id : needed)
      if (squares_[id] == graph::zero) squares_[id] = square(id);
  }

  /// Of one of the expressions.
  constexpr int operator[](int expression) const { return squares_[expression]; }

private:
  constexpr bool is_coordinate(int id) const {
    return g_[id].op == operation::symbol && g_.symbol_at(id).kind == symbol_kind::coordinate;
  }

  constexpr void count_with_their_like(const sequence<int>& coordinates, sequence<int> sums,
                                       const sequence<int>& more) {
    for (int id : more) sums.push(id);
    if (coordinates.size() == 1) sums.clear(); // there is no other
    const units found(g_, sums);
    for (int one : coordinates) {
      int total = graph::zero, count = 0;
      for (int other : coordinates)
        if (one == other || found.are_alike(one, other))
          total = add(g_, total, multiply(g_, other, other)), ++count;
      squares_[one] = multiply(g_, g_.constant(exactly(1, count)), total);
    }
  }

  /// The sums and products that expressions are made of, with what those are made of, in their order.
  constexpr sequence<int> terms_of(const sequence<int>& expressions) const {
    sequence<char> marks(g_.size(), 0);
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
  sequence<int> squares_; ///< by node
};

/// The mean square of a determinant, from those of its entries by rows: their permanent.
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
