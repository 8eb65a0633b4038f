#pragma once

#include <kanexpr/symbolic/derivatives/differentiate.hpp>
#include <kanexpr/symbolic/graph/canonical_order.hpp>

namespace kanexpr::symbolic {

/// Reverse accumulation: the gradient of Σ seed·output by every symbol, in one pass over the graph.
///
/// Griewank & Walther, Evaluating Derivatives (2008), section 3.2. Give some of the outputs a weight with
/// `seed`, then `run` once, then ask for the gradient by any symbol; `restart` for other weights.
class accumulation {
public:
  constexpr accumulation(graph& g, const sequence<expression>& outputs)
      : graph_(g), adjoints_(g.size(), graph::zero), order_(users_first(g, nodes_of(outputs))) {}

  constexpr void seed(expression output, expression weight) { collect(output.node(), weight.node()); }

  constexpr void restart() {
    for (int id : order_) adjoints_[id] = graph::zero;
  }

  constexpr void run() {
    for (int id : order_) {
      const node n = graph_[id];
      if (adjoints_[id] == graph::zero || is_leaf(n.op)) continue;
      if (n.op == operation::component) {
        adjoints_[n.a] = graph::one; // all of a solution at once, when its turn comes
        continue;
      }
      if (n.op == operation::solve || n.op == operation::transposed_solve) {
        back_through(id, n);
        continue;
      }
      if (n.op == operation::singularity_measure) continue;
      const int adjoint = adjoints_[id];
      if (n.op == operation::multiply && n.a == n.b) { // the 2 meets the ½ of an energy
        collect(n.a, multiply(graph_, multiply(graph_, graph_.constant(exactly(2)), adjoint), n.a));
        continue;
      }
      const partials p = local_partials(graph_, id);
      collect(n.a, multiply(graph_, p.by_a, adjoint));
      if (is_binary(n.op)) collect(n.b, multiply(graph_, p.by_b, adjoint));
    }
  }

  constexpr expression by(expression symbol) const { return {graph_, adjoints_[symbol.node()]}; }

private:
  constexpr void collect(int id, int part) {
    int& adjoint = adjoints_[id];
    adjoint = add(graph_, adjoint, part);
  }

  /// The adjoint of b is λ in Aᵀ λ = x̄, and that of A is -λ xᵀ.
  constexpr void back_through(int id, const node& n) {
    const expression factors{graph_, n.a};
    const bool is_transposed = n.op == operation::transposed_solve;
    const sequence<int> entries = entries_of(graph_, n.a), right = elements_of(graph_, n.b);
    const int order = right.size();
    sequence<expression> x, weights;
    for (int i = 0; i < order; ++i) {
      x.push({graph_, component(graph_, id, i)});
      const int place = x[i].node();
      weights.push({graph_, place < adjoints_.size() ? adjoints_[place] : graph::zero});
    }
    const operation transposed = is_transposed ? operation::solve : operation::transposed_solve;
    const sequence<expression> lambda = solve(transposed, factors, weights);
    for (int i = 0; i < order; ++i) {
      collect(right[i], lambda[i].node());
      for (int j = 0; j < order; ++j)
        if (entries[i * order + j] != graph::zero)
          collect(entries[i * order + j], (is_transposed ? -(lambda[j] * x[i]) : -(lambda[i] * x[j])).node());
    }
  }

  graph& graph_;
  sequence<int> adjoints_;
  sequence<int> order_; ///< of the nodes that the outputs depend on
};

} // namespace kanexpr::symbolic
