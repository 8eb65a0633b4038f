#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/base/zeros.hpp>
#include <kanexpr/symbolic/derivatives/dependence.hpp>
#include <kanexpr/symbolic/graph/build.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/external.hpp>
#include <kanexpr/symbolic/graph/functions.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/linear/linear_system.hpp>

namespace kanexpr::symbolic {

/// A component of a vector rotated about an axis: c a − s b or s a + c b, where c and s are the cosine and
/// sine of an angle. Its derivative with respect to the angle is, up to sign, the other component, which
/// usually exists already. The chain rule through sine and cosine would need two more products.
struct rotated_component {
  int angle = -1; ///< -1: not a rotated component
  /// The factors of the two products: a sine or cosine, and a value.
  int trigonometric[2]{}, value[2]{};
  bool adds = false; ///< whether the second is added to the first

  constexpr explicit operator bool() const { return angle >= 0; }
};

namespace detail {

/// For a sum or difference of the nodes a and b.
template <class Nodes>
constexpr rotated_component rotated_component_of(const Nodes& nodes, int a, int b, bool adds) {
  rotated_component found;
  if (nodes[a].op != operation::multiply || nodes[b].op != operation::multiply) return found;
  for (int i = 0; i < 4; ++i) {
    const bool exchange_first = i % 2 != 0, exchange_second = i / 2 != 0;
    const int t = exchange_first ? nodes[a].b : nodes[a].a, w = exchange_second ? nodes[b].b : nodes[b].a;
    const operation one = nodes[t].op, other = nodes[w].op;
    if (one != operation::sin && one != operation::cos) continue;
    if (other != operation::sin && other != operation::cos) continue;
    if (nodes[t].a != nodes[w].a || one == other) continue;
    found.angle = nodes[t].a;
    found.trigonometric[0] = t, found.trigonometric[1] = w;
    found.value[0] = exchange_first ? nodes[a].a : nodes[a].b;
    found.value[1] = exchange_second ? nodes[b].a : nodes[b].b;
    found.adds = adds;
    break;
  }
  return found;
}

} // namespace detail

constexpr rotated_component rotated_component_at(const graph& g, const node& n) {
  if (n.op != operation::add && n.op != operation::subtract) return {};
  const bool adds = n.op == operation::add;
  return __builtin_is_constant_evaluated()
             ? detail::rotated_component_of(g.elements<true>(), n.a, n.b, adds)
             : detail::rotated_component_of(g.elements<false>(), n.a, n.b, adds);
}

/// The derivative with respect to the angle: a node, and whether its sign must be changed.
struct rotated_derivative {
  int value;
  bool is_negative;
};

constexpr rotated_derivative derivative_by_angle(graph& g, const rotated_component& x) {
  const int by_first = multiply(g, x.trigonometric[1], x.value[0]),
            by_second = multiply(g, x.trigonometric[0], x.value[1]);
  const bool begins_with_cosine = g[x.trigonometric[0]].op == operation::cos;
  // c a + s b: c b − s a; c a − s b: −(s a + c b); s a + c b: c a − s b; s a − c b: c a + s b
  if (!x.adds) return {add(g, by_first, by_second), begins_with_cosine};
  if (begins_with_cosine) return {subtract(g, by_second, by_first), false};
  return {subtract(g, by_first, by_second), false};
}

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
  case form::leaf:                  // no operands
  case form::list_operation: break; // differentiated below
  }
  return {zero, zero};
}

/// Directional derivatives: every symbol has a rate, and the rate of an expression follows by the chain rule.
///
/// Results are cached, so that common subexpressions are differentiated only once.
class differentiation {
public:
  constexpr differentiation() = default;
  differentiation(const differentiation&) = delete;
  differentiation(differentiation&&) = default;
  differentiation& operator=(const differentiation&) = delete;
  differentiation& operator=(differentiation&&) = default;
  constexpr explicit differentiation(graph& g) : graph_(&g) {}

  /// Sets the rate of a symbol; the default is zero. Must be called before the first `of`.
  constexpr void set_rate(expression symbol, expression rate) { remember(symbol.node(), rate.node()); }

  /// Skips the nodes that do not change along a direction; all symbols that have a rate must be marked. The
  /// marks must outlive the derivatives.
  constexpr void skip_unchanged(const dependence& found, int direction) {
    marks_ = found.begin() + direction / 64;
    stride_ = found.words();
    marked_ = found.size();
    mark_ = dependence::word{1} << (direction % 64);
  }

  constexpr expression of(expression e) { return {*graph_, of(e.node())}; }

  /// Clears all rates so that new ones can be set.
  constexpr void restart() {
    if (__builtin_is_constant_evaluated()) {
      rates_ = {};
      rate_of_ = nullptr;
      room_ = 0;
    }
    for (int id : known_) rates_[id] = unknown;
    known_.clear();
    marked_ = 0;
  }

private:
  static constexpr int unknown = 0; ///< rates are stored as one more than their node

  constexpr void remember(int id, int rate) {
    if (room_ <= id) make_room();
    rate_of_[id] = rate + 1;
    if (!__builtin_is_constant_evaluated()) known_.push(id);
  }

  constexpr void make_room() {
    constexpr int room = base::zeros<int>::room;
    rates_.grow(__builtin_is_constant_evaluated() && graph_->size() < room ? room : 2 * graph_->size());
    rate_of_ = rates_.begin();
    room_ = rates_.size();
  }

  constexpr int of(int id) {
    if (id < room_ && rate_of_[id] != unknown) return rate_of_[id] - 1;
    const int marks = id * stride_;
    if (id < marked_ && (marks_[marks] & mark_) == 0) return graph::zero;
    graph& g = *graph_;
    const node n = g.node_at(id);
    if (n.op <= operation::symbol) return graph::zero; // a leaf
    int rate = graph::zero;
    if (n.op == operation::add || n.op == operation::subtract) {
      if (const rotated_component x = rotated_component_at(g, n); x && of(x.angle) != graph::zero) {
        rate = of_rotated(x);
      } else {
        const int a = of(n.a), b = of(n.b);
        rate = n.op == operation::add ? add(g, a, b) : subtract(g, a, b);
      }
    } else if (n.op == operation::multiply) {
      const int a = of(n.a), b = of(n.b);
      int through_a = graph::zero, through_b = graph::zero;
      if (a != graph::zero) through_a = multiply(g, n.b, a);
      if (b != graph::zero) through_b = multiply(g, n.a, b);
      rate = add(g, through_a, through_b);
    } else if (n.op == operation::component) {
      rate = component(g, of_solution(n.a), integer_at(g, n.b));
    } else if (n.op == operation::call) {
      rate = of_call(id);
    } else if (is_selection(n.op)) {
      const int through_b = of(n.b);
      rate = selected(g, n.op, n.a, through_b);
    } else if (n.op != operation::singularity_measure) {
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

  constexpr int of_rotated(const rotated_component& x) {
    graph& g = *graph_;
    const int first = multiply(g, x.trigonometric[0], of(x.value[0]));
    const int second = multiply(g, x.trigonometric[1], of(x.value[1]));
    const rotated_derivative slope = derivative_by_angle(g, x);
    const int by_angle = multiply(g, slope.value, of(x.angle));
    const int rate = x.adds ? add(g, first, second) : subtract(g, first, second);
    return slope.is_negative ? subtract(g, rate, by_angle) : add(g, rate, by_angle);
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
    if (id < room_ && rate_of_[id] != unknown) return rate_of_[id] - 1;
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
  base::zeros<int> rates_{}; ///< by node
  int* rate_of_ = nullptr;   ///< the same, because compilers interpret every call
  int room_ = 0;
  sequence<int> known_{}; ///< nodes with a rate; empty in constant evaluation
  const dependence::word* marks_ = nullptr;
  int stride_ = 0, marked_ = 0;
  dependence::word mark_ = 0;
};

/// The partial derivative of an expression with respect to a symbol.
constexpr expression differentiate(expression e, expression symbol) {
  differentiation d(e.owner());
  d.set_rate(symbol, expression{e.owner(), graph::one});
  return d.of(e);
}

} // namespace kanexpr::symbolic
