#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/base/text.hpp>
#include <kanexpr/symbolic/graph/build.hpp>
#include <kanexpr/symbolic/graph/external.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>

#include <concepts>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace kanexpr::symbolic {

/// A number in an expression. Characters are excluded, because '2' would become 50.
template <class Number>
concept plain_number = std::is_arithmetic_v<Number> && !base::letter<Number>;

/// A scalar expression: a node and its graph, with the operators of ordinary algebra. At run time, an
/// operation on expressions from two graphs yields an expression without a graph, as does any operation on
/// the result.
class expression {
public:
  constexpr expression() = default;
  constexpr expression(graph& owner, int node) : graph_(&owner), node_(node) {}

  constexpr int node() const { return node_; }
  /// Whether the expression belongs to a graph.
  constexpr bool is_given() const { return graph_ != nullptr; }
  constexpr graph& owner() const { return *graph_; }
  constexpr bool belongs_to(const graph& g) const { return graph_ == &g; }
  constexpr bool is_zero() const { return node_ == graph::zero; }
  constexpr bool is_one() const { return node_ == graph::one; }
  constexpr bool is_constant() const {
    return (__builtin_is_constant_evaluated() || is_given()) && graph_->is_constant(node_);
  }
  /// Equality of nodes; local rules reduce most equal expressions to the same node.
  constexpr bool operator==(const expression& other) const { return node_ == other.node_; }

  constexpr expression number(const symbolic::number& value) const {
    if (!__builtin_is_constant_evaluated() && !is_given()) return {};
    return {*graph_, graph_->constant(value)};
  }

  // These functions change a copy of an operand, which costs compilers one call less than a constructor. They
  // return sums with zero and products with zero or one without a further call, because most operations of a
  // derivation are such.
  friend constexpr expression operator-(expression a) {
    if (!__builtin_is_constant_evaluated() && !a.is_given()) return {};
    if (a.node_ != graph::zero) a.node_ = negate(*a.graph_, a.node_);
    return a;
  }
  friend constexpr expression operator+(expression a, expression b) {
    if (!__builtin_is_constant_evaluated() && !share_a_graph(a, b)) return {};
    if (a.node_ == graph::zero) return b;
    if (b.node_ != graph::zero) a.node_ = add(*a.graph_, a.node_, b.node_);
    return a;
  }
  friend constexpr expression operator-(expression a, expression b) {
    if (!__builtin_is_constant_evaluated() && !share_a_graph(a, b)) return {};
    if (b.node_ != graph::zero) a.node_ = subtract(*a.graph_, a.node_, b.node_);
    return a;
  }
  friend constexpr expression operator*(expression a, expression b) {
    if (!__builtin_is_constant_evaluated() && !share_a_graph(a, b)) return {};
    if (a.node_ == graph::zero || b.node_ == graph::one) return a;
    if (b.node_ == graph::zero || a.node_ == graph::one) return b;
    a.node_ = multiply(*a.graph_, a.node_, b.node_);
    return a;
  }
  friend constexpr expression operator/(expression a, expression b) {
    if (!__builtin_is_constant_evaluated() && !share_a_graph(a, b)) return {};
    a.node_ = divide(*a.graph_, a.node_, b.node_);
    return a;
  }
  /// a b + c d. C++ does not fix the evaluation order of the operands of `+`, and nodes are numbered as they
  /// are created; so here, and wherever several operands create nodes, each is first stored in a named
  /// variable.
  friend constexpr expression sum_of_products(expression a, expression b, expression c, expression d) {
    if (!__builtin_is_constant_evaluated() &&
        !(share_a_graph(a, b) && share_a_graph(a, c) && share_a_graph(a, d)))
      return {};
    if (c.node_ == graph::zero || d.node_ == graph::zero) return a * b;
    if (a.node_ == graph::zero || b.node_ == graph::zero) return c * d;
    const expression first = a * b, second = c * d;
    return first + second;
  }
  /// a b − c d.
  friend constexpr expression difference_of_products(expression a, expression b, expression c, expression d) {
    if (!__builtin_is_constant_evaluated() &&
        !(share_a_graph(a, b) && share_a_graph(a, c) && share_a_graph(a, d)))
      return {};
    if (c.node_ == graph::zero || d.node_ == graph::zero) return a * b;
    const expression first = a * b, second = c * d;
    return first - second;
  }
  friend constexpr expression operator+(expression a, plain_number auto b) { return a + a.converted(b); }
  friend constexpr expression operator+(plain_number auto a, expression b) { return b.converted(a) + b; }
  friend constexpr expression operator-(expression a, plain_number auto b) { return a - a.converted(b); }
  friend constexpr expression operator-(plain_number auto a, expression b) { return b.converted(a) - b; }
  friend constexpr expression operator*(expression a, plain_number auto b) { return a * a.converted(b); }
  friend constexpr expression operator*(plain_number auto a, expression b) { return b.converted(a) * b; }
  friend constexpr expression operator/(expression a, plain_number auto b) { return a / a.converted(b); }
  friend constexpr expression operator/(plain_number auto a, expression b) { return b.converted(a) / b; }
  constexpr expression& operator+=(expression b) { return *this = *this + b; }
  constexpr expression& operator-=(expression b) { return *this = *this - b; }
  constexpr expression& operator*=(expression b) { return *this = *this * b; }

  static constexpr bool share_a_graph(expression a, expression b) {
    return a.graph_ == b.graph_ && a.is_given();
  }

private:
  /// Integers stay exact: q/2 contains the fraction 1/2.
  constexpr expression integer(std::int64_t value) const {
    if (value == 0 && !__builtin_is_constant_evaluated() && is_given()) graph_->record_integer_zero();
    return number(exactly(value));
  }
  template <class Number>
  constexpr expression converted(Number value) const {
    if constexpr (std::floating_point<Number>)
      return number(real(static_cast<double>(value)));
    else if constexpr (sizeof(Number) <= sizeof(int))
      return integer(value);
    else
      return std::in_range<std::int64_t>(value) ? integer(static_cast<std::int64_t>(value))
                                                : number(real(static_cast<double>(value)));
  }

  // No default initializers: the compiler would run them for every element of an array. {} is the zero
  // without a graph.
  graph* graph_;
  int node_;
};

constexpr expression sum_of_products(expression a, expression b, expression c, expression d);
constexpr expression difference_of_products(expression a, expression b, expression c, expression d);

constexpr expression apply(operation op, expression a) {
  if (!__builtin_is_constant_evaluated() && !a.is_given()) return {};
  return {a.owner(), apply(a.owner(), op, a.node())};
}
constexpr expression apply(operation op, expression a, expression b) {
  if (!__builtin_is_constant_evaluated() && !expression::share_a_graph(a, b)) return {};
  return {a.owner(), apply(a.owner(), op, a.node(), b.node())};
}
/// x if the condition is positive (or, for the other operation, not positive), otherwise zero.
constexpr expression selected(operation op, expression condition, expression x) {
  if (!__builtin_is_constant_evaluated() && !expression::share_a_graph(condition, x)) return {};
  return {x.owner(), selected(x.owner(), op, condition.node(), x.node())};
}
constexpr expression power(expression base, expression exponent) {
  if (!__builtin_is_constant_evaluated() && !expression::share_a_graph(base, exponent)) return {};
  return {base.owner(), power(base.owner(), base.node(), exponent.node())};
}

/// A call to a user-defined function; it requires at least one operand, and all operands must share a graph.
constexpr expression call(const external_function& f, const sequence<expression>& operands) {
  sequence<int> nodes;
  for (const expression& each : operands) {
    if (!__builtin_is_constant_evaluated() && !expression::share_a_graph(operands[0], each)) return {};
    nodes.push(each.node());
  }
  graph& g = operands[0].owner();
  return {g, call(g, f, list_of(g, nodes))};
}

constexpr expression constant(graph& g, const number& value) { return {g, g.constant(value)}; }
constexpr expression variable(graph& g, const symbol& s) { return {g, g.variable(s)}; }

constexpr sequence<int> nodes_of(const sequence<expression>& all) {
  sequence<int> nodes;
  for (const expression& e : all) nodes.push(e.node());
  return nodes;
}
constexpr sequence<expression> expressions_of(graph& g, const sequence<int>& nodes) {
  sequence<expression> all;
  for (int id : nodes) all.push({g, id});
  return all;
}

} // namespace kanexpr::symbolic
