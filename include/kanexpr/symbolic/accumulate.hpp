#pragma once

#include <kanexpr/symbolic/differentiate.hpp>

namespace kanexpr::symbolic {

/// Reverse accumulation: the gradient of Σ seed·output by every symbol, in one pass over the graph.
///
/// Griewank & Walther, Evaluating Derivatives (2008), section 3.2. Add the outputs with `seed`, then `run`
/// once, then ask for the gradient by any symbol.
class accumulation {
public:
  constexpr explicit accumulation(graph& g) : graph_(&g), adjoints_(g.size(), graph::zero) {}

  constexpr void seed(expression output, expression weight) { collect(output.node(), weight); }

  constexpr void run() {
    for (int id = adjoints_.size() - 1; id >= 0; --id) {
      const node n = (*graph_)[id];
      if (adjoints_[id] == graph::zero || is_leaf(n.op)) continue;
      const expression adjoint{*graph_, adjoints_[id]};
      const partials p = local_partials(*graph_, id);
      collect(n.a, p.by_a * adjoint);
      if (is_binary(n.op)) collect(n.b, p.by_b * adjoint);
    }
  }

  constexpr expression by(expression symbol) const { return {*graph_, adjoints_[symbol.node()]}; }

private:
  constexpr void collect(int id, expression part) {
    adjoints_[id] = (expression{*graph_, adjoints_[id]} + part).node();
  }

  graph* graph_;
  sequence<int> adjoints_;
};

} // namespace kanexpr::symbolic
