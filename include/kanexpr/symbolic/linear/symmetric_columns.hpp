#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/base/zeros.hpp>
#include <kanexpr/numeric/symmetric_columns.hpp>
#include <kanexpr/symbolic/graph/build.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/live_nodes.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

/// M X = B for many columns as one node, whose steps the lowering repeats for each column instead of writing
/// them out.
namespace kanexpr::symbolic {

/// The operands of a node that solves for many columns.
struct symmetric_columns {
  sequence<int> factors{}, right{}; ///< B row by row
  int order = 0, columns = 0;

  constexpr symmetric_columns(const graph& g, const node& n)
      : factors(elements_of_rows(g, n.a)), right(elements_of_rows(g, n.b)),
        order(numeric::symmetric_factors::order_of(factors.size())), columns(right.size() / order) {}

  constexpr numeric::column_steps steps() const {
    return {order, [&](int factor) { return factors[factor] == graph::zero; },
            [&](int row) {
              for (int j = 0; j < columns; ++j)
                if (right[row * columns + j] != graph::zero) return false;
              return true;
            }};
  }
};

namespace detail {

/// A product that is not combined with other constants, and is therefore rounded as in a step on columns.
constexpr int product_as_written(graph& g, int a, int b) {
  const node x = g[a], y = g[b];
  const bool is_constant = x.op == operation::constant;
  if (a <= graph::one || b <= graph::one || (is_constant && y.op == operation::constant))
    return multiply(g, a, b);
  if (is_constant && g.number_at(a).negative())
    return negate(g, product_as_written(g, g.constant(-g.number_at(a)), b));
  if (x.op == operation::negate) return negate(g, product_as_written(g, x.a, b));
  if (y.op == operation::constant || y.op == operation::negate || b < a) {
    if (!is_constant) return product_as_written(g, b, a);
    if (y.op == operation::negate) return negate(g, product_as_written(g, a, y.a));
  }
  return g.find_or_append({operation::multiply, a, b});
}

/// A difference whose terms are not combined.
constexpr int difference_as_written(graph& g, int a, int b) {
  const node x = g[a], y = g[b];
  if (a == graph::zero || b == graph::zero || a == b ||
      (x.op == operation::constant && y.op == operation::constant))
    return subtract(g, a, b);
  if (y.op != operation::negate) return g.find_or_append({operation::subtract, a, b});
  return g.find_or_append(a < y.a ? node{operation::add, a, y.a} : node{operation::add, y.a, a});
}

/// Replaces the nodes that solve for many columns by the operations of each column.
class column_expansion {
public:
  constexpr column_expansion(graph& g, const sequence<int>& outputs) : g_(g), image_(g.size()) {
    const base::zeros<char> live = live_nodes(g, outputs);
    int* const image = image_.begin();
    for (int id = 0, end = live.size(); id < end; ++id) {
      image[id] = id;
      const node n = g_[id];
      if (live[id] == 0 || is_leaf(n.op)) continue;
      const int a = image[n.a], b = !is_binary(n.op) ? 0 : live[n.b] != 0 ? image[n.b] : n.b;
      if (n.op == operation::component && g_[n.a].op == operation::symmetric_solve)
        image[id] = written_out(n.a)[integer_at(g_, n.b)];
      else if (a != n.a || b != n.b)
        image[id] = build(g_, n.op, a, b);
    }
  }

  constexpr int operator[](int id) const { return image_[id]; }

private:
  constexpr const sequence<int>& written_out(int solution) {
    const int known = solutions_.find(solution);
    if (known >= 0) return unknowns_[known];
    symmetric_columns system(g_, g_[solution]);
    const numeric::column_steps steps = system.steps();
    for (int& id : system.factors) id = image_[id];
    for (int& id : system.right) id = image_[id];
    sequence<int>& x = system.right;
    for (int j = 0; j < system.columns; ++j)
      for (const numeric::column_step& s : steps.all) {
        int& to = x[s.to * system.columns + j];
        const int product = product_as_written(g_, system.factors[s.factor], x[s.from * system.columns + j]);
        to = s.is_pivot() ? product : s.fills ? negate(g_, product) : difference_as_written(g_, to, product);
      }
    solutions_.push(solution);
    return unknowns_[unknowns_.push(x)];
  }

  graph& g_;
  base::zeros<int> image_;
  sequence<int> solutions_{};          ///< nodes
  sequence<sequence<int>> unknowns_{}; ///< of each of them
};

} // namespace detail

/// Whether any live node solves for many columns.
constexpr bool has_symmetric_columns(const graph& g, const sequence<int>& outputs) {
  if (!g.has_lists()) return false;
  for (int id : live_values(g, outputs))
    if (g[id].op == operation::symmetric_solve) return true;
  return false;
}

/// Writes all operations out, for those who read, differentiate or rearrange the expressions.
constexpr matrix written_out(matrix m) {
  sequence<int> outputs;
  for (const expression& e : m.entries) outputs.push(e.node());
  if (outputs.empty()) return m;
  graph& g = m.entries[0].owner();
  if (!has_symmetric_columns(g, outputs)) return m;
  const detail::column_expansion image(g, outputs);
  for (expression& e : m.entries) e = {g, image[e.node()]};
  return m;
}

} // namespace kanexpr::symbolic
