#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/base/zeros.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>
#include <kanexpr/symbolic/graph/canonical_order.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/external.hpp>
#include <kanexpr/symbolic/graph/function_table.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/live_nodes.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

namespace kanexpr::symbolic {

/// Reverse accumulation: the gradient of Σ seed·output with respect to every symbol, in one pass over the
/// graph.
///
/// Griewank & Walther, Evaluating Derivatives (2008), section 3.2. Assign weights to outputs with `seed`,
/// call `run` once, then query the gradient with respect to any symbol; `restart` prepares for other
/// weights.
class accumulation {
  // precedes its callers, because clang++ does not instantiate a template for a constant expression if it is
  // declared later in the class
  template <class Nodes, class Uses>
  constexpr void count_uses(const Nodes& nodes, Uses& uses) const {
    for (int id : order_) {
      const operation op = nodes[id].op;
      if (is_leaf(op)) continue;
      ++uses[nodes[id].a];
      if (is_binary(op)) ++uses[nodes[id].b];
    }
  }

  template <bool is_constant>
  constexpr void propagate_all() {
    const auto& adjoints = adjoints_.elements<is_constant>();
    for (int id : order_) {
      const int adjoint = adjoints[id];
      if (adjoint == graph::zero) continue;
      const auto& nodes = graph_.elements<is_constant>(); // not before the loop, because the graph grows
      const operation op = nodes[id].op;
      const int a = nodes[id].a, b = nodes[id].b;
      if (is_leaf(op) || (!held_.empty() && held_[id] != 0)) continue;
      if (op == operation::multiply && a != b) { // the most frequent one, without a copy of the node
        collect(a, multiply(graph_, b, adjoint));
        collect(b, multiply(graph_, a, adjoint));
        continue;
      }
      const node n{op, a, b};
      if (n.op == operation::component)
        adjoints_[n.a] = graph::one; // the complete solution is processed when its node is reached
      else if (is_solution(n.op))
        propagate_solve(id, n);
      else if (n.op == operation::call)
        propagate_call(id, n, adjoint);
      else if (is_selection(n.op))
        propagate_selection(n, adjoint);
      else if (n.op == operation::add || n.op == operation::subtract)
        propagate_sum(n, adjoint);
      else if (n.op != operation::singularity_measure)
        propagate_partials(id, n, adjoint);
    }
  }

public:
  constexpr accumulation(graph& g, const sequence<expression>& outputs)
      : graph_(g), adjoints_(g.size()), uses_(g.size()),
        order_(reverse_topological_order(g, nodes_of(outputs))) {
    for (const expression& e : outputs) ++uses_[e.node()];
    if (__builtin_is_constant_evaluated())
      count_uses(g.elements<true>(), uses_.elements<true>());
    else
      count_uses(g.elements<false>(), uses_.elements<false>());
  }

  constexpr void seed(expression output, expression weight) { collect(output.node(), weight.node()); }

  constexpr void restart() {
    if (__builtin_is_constant_evaluated()) {
      adjoints_ = base::zeros<int>(adjoints_.size());
      return;
    }
    for (int id : order_) adjoints_[id] = graph::zero;
  }

  /// Treats a node as a symbol in all passes: the gradient does not reach its operands through it.
  constexpr void hold(expression e) {
    if (held_.empty()) held_.resize(graph_.size(), 0);
    held_[e.node()] = 1;
  }

  constexpr void run() {
    if (__builtin_is_constant_evaluated())
      propagate_all<true>();
    else
      propagate_all<false>();
  }

  constexpr expression by(expression symbol) const { return {graph_, adjoints_[symbol.node()]}; }

private:
  constexpr void collect(int id, int part) {
    int& adjoint = adjoints_[id];
    adjoint = adjoint == graph::zero ? part : add(graph_, adjoint, part);
  }

  constexpr void propagate_partials(int id, const node& n, int adjoint) {
    if (n.op == operation::multiply && n.a == n.b) { // the 2 cancels the ½ of an energy
      collect(n.a, multiply(graph_, multiply(graph_, graph_.constant(exactly(2)), adjoint), n.a));
      return;
    }
    const partials p = local_partials(graph_, id);
    collect(n.a, multiply(graph_, p.by_a, adjoint));
    if (is_binary(n.op)) collect(n.b, multiply(graph_, p.by_b, adjoint));
  }

  /// Propagates the adjoint of a rotated component with one product for the angle and one for each rotated
  /// value.
  constexpr void propagate_sum(const node& n, int adjoint) {
    const rotated_component x = rotated_component_at(graph_, n);
    if (!x || uses_[n.a] != 1 || uses_[n.b] != 1) {
      collect(n.a, adjoint);
      collect(n.b, n.op == operation::add ? adjoint : negate(graph_, adjoint));
      return;
    }
    const rotated_derivative slope = derivative_by_angle(graph_, x);
    collect(x.angle, slope.value, adjoint, slope.is_negative);
    collect(x.value[0], x.trigonometric[0], adjoint, false);
    collect(x.value[1], x.trigonometric[1], adjoint, !x.adds);
  }

  constexpr void propagate_call(int id, const node& n, int adjoint) {
    const external_function& f = graph_.external_at(id);
    const sequence<int> operands = elements_of(graph_, n.a);
    for (int i = 0; i < operands.size(); ++i)
      if (!graph_.is_constant(operands[i]))
        collect(operands[i], multiply(graph_, adjoint, call(graph_, f.slope(i), n.a)));
  }

  /// The branch that is not selected must not affect the result, but zero times an infinite derivative is
  /// NaN. Therefore, if a derivative may be infinite, the selection is applied to the derivative with respect
  /// to each symbol.
  constexpr void propagate_selection(const node& n, int adjoint) {
    bool stays_finite = true;
    sequence<int> symbols;
    for (int id : live_values(graph_, {n.b})) {
      if (graph_[id].op == operation::symbol) symbols.push(id);
      stays_finite = stays_finite && has_finite_slopes(graph_[id]);
    }
    if (stays_finite) return collect(n.b, selected(graph_, n.op, n.a, adjoint));
    for (int id : symbols) {
      const int slope = differentiate(expression{graph_, n.b}, expression{graph_, id}).node();
      collect(id, multiply(graph_, adjoint, selected(graph_, n.op, n.a, slope)));
    }
  }

  /// Whether the derivatives are finite wherever the operands are finite.
  constexpr bool has_finite_slopes(const node& n) const {
    switch (form_of(n.op)) {
    case form::divide: return graph_.is_constant(n.b);
    case form::function: return properties_of(n.op).has_finite_slopes();
    case form::leaf:
    case form::negate:
    case form::add:
    case form::subtract:
    case form::multiply:
    case form::selection: return true;
    case form::power:
    case form::binary_function:
    case form::list_operation: break;
    }
    return false;
  }

  constexpr void collect(int id, int slope, int adjoint, bool is_negative) {
    const int part = multiply(graph_, slope, adjoint);
    collect(id, is_negative ? negate(graph_, part) : part);
  }

  /// The adjoint of b is the solution λ of Aᵀ λ = x̄, and that of A is -λ xᵀ.
  constexpr void propagate_solve(int id, const node& n) {
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
  base::zeros<int> adjoints_;
  base::zeros<int> uses_; ///< the number of uses by live nodes
  sequence<int> order_;   ///< live nodes, users first
  sequence<char> held_{}; ///< by node, empty if none is held
};

} // namespace kanexpr::symbolic
