#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/derivatives/turned_component.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/external.hpp>
#include <kanexpr/symbolic/graph/functions.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/linear/linear_system.hpp>

namespace kanexpr::symbolic {

/// The partial derivatives of an operation with respect to its operands, as nodes in terms of the operands
/// and the result.
struct partials {
  int by_a;
  int by_b;
};

constexpr partials local_partials(graph& g, int id) {
  const node n = g[id];
  constexpr int zero = graph::zero, one = graph::one;
  switch (form_of(n.op)) {
  case form::negate: return {negate(g, one), zero};
  case form::add: return {one, one};
  case form::subtract: return {one, negate(g, one)};
  case form::multiply: return {n.b, n.a};
  case form::divide: return {divide(g, one, n.b), negate(g, divide(g, id, n.b))};
  case form::power: {
    const expression f{g, id}, a{g, n.a}, b{g, n.b}, by_base = b * power(a, b - 1);
    return {by_base.node(), b.is_constant() ? zero : (f * log(a)).node()};
  }
  case form::function: return {slope_of(n.op, expression{g, n.a}, expression{g, id}).node(), zero};
  case form::binary_function: {
    const auto slopes = binary_slopes_of(n.op, expression{g, n.a}, expression{g, n.b}, expression{g, id});
    return {slopes.by_a.node(), slopes.by_b.node()};
  }
  case form::selection: return {zero, selected(g, n.op, n.a, one)};
  case form::constant: // no operands
  case form::symbol:
  case form::singularity_measure: // never differentiated
  case form::pair:                // differentiated below
  case form::factorization:
  case form::solve:
  case form::transposed_solve:
  case form::component:
  case form::call: break;
  }
  return {zero, zero};
}

/// Directional derivatives: every symbol has a rate, and the rate of an expression follows by the chain rule.
///
/// Results are cached, so that common subexpressions are differentiated only once.
class differentiation {
public:
  constexpr differentiation() = default;
  differentiation(const differentiation&) = default;
  differentiation(differentiation&&) = default;
  differentiation& operator=(const differentiation&) = default;
  differentiation& operator=(differentiation&&) = default;
  constexpr explicit differentiation(graph& g) : graph_(&g) {}

  /// Sets the rate of a symbol; the default is zero. Must be called before the first `of`.
  constexpr void set_rate(expression symbol, expression rate) { remember(symbol.node(), rate.node()); }

  constexpr expression of(expression e) { return {*graph_, of(e.node())}; }

  /// Clears all rates so that new ones can be set.
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
    if (const turned_component x = turned_component_at(*graph_, n); x && of(x.angle) != graph::zero) {
      graph& g = *graph_;
      const int first = multiply(g, x.circular[0], of(x.value[0]));
      const int second = multiply(g, x.circular[1], of(x.value[1]));
      const turned_slope slope = slope_by_angle(g, x);
      const int by_angle = multiply(g, slope.value, of(x.angle));
      rate = x.adds ? add(g, first, second) : subtract(g, first, second);
      rate = slope.is_negative ? subtract(g, rate, by_angle) : add(g, rate, by_angle);
    } else if (n.op == operation::component) {
      rate = component(*graph_, of_solution(n.a), integer_at(*graph_, n.b));
    } else if (n.op == operation::call) {
      rate = of_call(id);
    } else if (is_selection(n.op)) {
      const int through_b = of(n.b);
      rate = selected(*graph_, n.op, n.a, through_b);
    } else if (!is_leaf(n.op) && n.op != operation::singularity_measure) {
      graph& g = *graph_;
      const int a = of(n.a), b = is_binary(n.op) ? of(n.b) : graph::zero;
      if (n.op == operation::divide) {
        rate = divide(g, subtract(g, a, multiply(g, id, b)), n.b);
      } else if (a != graph::zero || b != graph::zero) {
        const partials p = local_partials(g, id);
        const int through_a = multiply(g, p.by_a, a), through_b = multiply(g, p.by_b, b);
        rate = add(g, through_a, through_b);
      }
    }
    remember(id, rate);
    return rate;
  }

  constexpr int of_call(int id) {
    graph& g = *graph_;
    const external_function& f = g.external_at(id);
    const int list = g[id].a;
    const sequence<int> operands = elements_of(g, list);
    int rate = graph::zero;
    for (int i = 0; i < operands.size(); ++i)
      if (const int along = of(operands[i]); along != graph::zero) {
        const int through = multiply(g, call(g, f.slope(i), list), along);
        rate = add(g, rate, through);
      }
    return rate;
  }

  /// Solves A ẋ = ḃ - Ȧ x, reusing the factorization of A.
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
  sequence<int> known_{}; ///< nodes with a rate
};

/// The partial derivative of an expression with respect to a symbol.
constexpr expression differentiate(expression e, expression symbol) {
  differentiation d(e.owner());
  d.set_rate(symbol, expression{e.owner(), graph::one});
  return d.of(e);
}

} // namespace kanexpr::symbolic
