#pragma once

#include <kanexpr/symbolic/graph/functions.hpp>
#include <kanexpr/symbolic/linear/linear_system.hpp>

namespace kanexpr::symbolic {

/// The partial derivatives of an operation by its operands, as expressions of those and of its own value.
struct partials {
  expression by_a;
  expression by_b;
};

constexpr partials local_partials(graph& g, int id) {
  const node n = g[id];
  const expression f{g, id}, a{g, n.a}, b{g, is_binary(n.op) ? n.b : graph::zero};
  const expression zero{g, graph::zero}, one{g, graph::one};
  switch (form_of(n.op)) {
  case form::negate: return {-one, zero};
  case form::add: return {one, one};
  case form::subtract: return {one, -one};
  case form::multiply: return {b, a};
  case form::divide: return {one / b, -(f / b)};
  case form::power: {
    const expression by_base = b * power(a, b - 1);
    return {by_base, b.is_constant() ? zero : f * log(a)};
  }
  case form::function: return {slope_of(n.op, a, f), zero};
  case form::atan2: {
    const expression square = a * a + b * b;
    return {b / square, -(a / square)};
  }
  case form::constant: // have no operands
  case form::symbol:
  case form::singularity_measure: // is never differentiated
  case form::pair:                // have derivatives of their own, below
  case form::factorization:
  case form::solve:
  case form::transposed_solve:
  case form::component: break;
  }
  return {zero, zero};
}

/// Directional derivatives: every symbol has a rate, and an expression's rate follows by the chain rule.
///
/// Results are remembered, so that many expressions share their common parts.
class differentiation {
public:
  constexpr differentiation() = default;
  differentiation(const differentiation&) = default;
  differentiation(differentiation&&) = default;
  differentiation& operator=(const differentiation&) = default;
  differentiation& operator=(differentiation&&) = default;
  constexpr explicit differentiation(graph& g) : graph_(&g) {}

  /// The rate of a symbol's node; zero where none is set. To be set before the first `of`.
  constexpr void set_rate(expression symbol, expression rate) { remember(symbol.node(), rate.node()); }

  constexpr expression of(expression e) { return {*graph_, of(e.node())}; }

  /// Forgets all rates, to begin with others.
  constexpr void restart() {
    for (int id : known_) rates_[id] = unknown;
    known_.clear();
  }

private:
  static constexpr int unknown = -1;

  constexpr void remember(int id, int rate) {
    if (rates_.size() <= id) rates_.resize(graph_->size() + 64, unknown);
    rates_[id] = rate;
    known_.push(id);
  }

  constexpr int of(int id) {
    if (id < rates_.size() && rates_[id] != unknown) return rates_[id];
    const node n = (*graph_)[id];
    int rate = graph::zero;
    if (n.op == operation::component) {
      rate = component(*graph_, of_solution(n.a), integer_at(*graph_, n.b));
    } else if (!is_leaf(n.op) && n.op != operation::singularity_measure) {
      const expression a{*graph_, of(n.a)};
      const expression b{*graph_, is_binary(n.op) ? of(n.b) : graph::zero};
      if (n.op == operation::divide) {
        const expression f{*graph_, id}, below{*graph_, n.b};
        rate = ((a - f * b) / below).node();
      } else if (!a.is_zero() || !b.is_zero()) {
        const partials p = local_partials(*graph_, id);
        rate = (p.by_a * a + p.by_b * b).node();
      }
    }
    remember(id, rate);
    return rate;
  }

  /// A ẋ = ḃ - Ȧ x, with the factors that A has already.
  constexpr int of_solution(int id) {
    if (id < rates_.size() && rates_[id] != unknown) return rates_[id];
    const node n = (*graph_)[id];
    const bool is_transposed = n.op == operation::transposed_solve;
    const int order = order_of(*graph_, n.a);
    const sequence<int> entries = entries_of(*graph_, n.a);
    sequence<int> right = elements_of(*graph_, n.b);
    for (int& b : right) b = of(b);
    for (int i = 0; i < order; ++i)
      for (int j = 0; j < order; ++j) {
        const int rate = of(entries[i * order + j]), row = is_transposed ? j : i, by = is_transposed ? i : j;
        if (rate != graph::zero)
          right[row] = subtract(*graph_, right[row], multiply(*graph_, rate, component(*graph_, id, by)));
      }
    const int rate = solution(*graph_, n.op, n.a, list_of(*graph_, right));
    remember(id, rate);
    return rate;
  }

  graph* graph_ = nullptr;
  sequence<int> rates_{}; ///< by node
  sequence<int> known_{}; ///< the nodes that have one
};

/// The partial derivative of an expression by a symbol.
constexpr expression differentiate(expression e, expression symbol) {
  differentiation d(e.owner());
  d.set_rate(symbol, expression{e.owner(), graph::one});
  return d.of(e);
}

} // namespace kanexpr::symbolic
