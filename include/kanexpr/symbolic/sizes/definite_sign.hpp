#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/live_nodes.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

namespace kanexpr::symbolic {

namespace detail {

/// What is known about the sign of a real value: `least` is 1 if it is positive, 0 if it is not negative and
/// −1 if it may be negative; `greatest` is −1, 0 or 1 correspondingly.
struct sign_range {
  int least = -1, greatest = 1;

  constexpr bool is_zero() const { return least == 0 && greatest == 0; }

  constexpr sign_range operator-() const { return {-greatest, -least}; }
  constexpr sign_range operator+(const sign_range& other) const {
    sign_range sum;
    if (least >= 0 && other.least >= 0) sum.least = least > other.least ? least : other.least;
    if (greatest <= 0 && other.greatest <= 0)
      sum.greatest = greatest < other.greatest ? greatest : other.greatest;
    return sum;
  }
  constexpr sign_range operator*(const sign_range& other) const {
    if (is_zero() || other.is_zero()) return {0, 0};
    if (greatest <= 0) return -(-*this * other);
    if (other.greatest <= 0) return -(*this * -other);
    if (least < 0 || other.least < 0) return {};
    return {least < other.least ? least : other.least, 1};
  }
};

constexpr sign_range sign_of_node(const graph& g, int id, const base::sequence<sign_range>& known) {
  const node& n = g[id];
  const auto square = [](const sign_range& x) {
    return sign_range{x.least > 0 || x.greatest < 0 ? 1 : 0, 1};
  };
  if (n.op == operation::constant) {
    const double value = g.number_at(id).value();
    return {value > 0 ? 1 : value >= 0 ? 0 : -1, value < 0 ? -1 : value <= 0 ? 0 : 1};
  }
  if (n.op == operation::add) return known[n.a] + known[n.b];
  if (n.op == operation::subtract) return known[n.a] + -known[n.b];
  if (n.op == operation::negate) return -known[n.a];
  if (n.op == operation::multiply) return n.a == n.b ? square(known[n.a]) : known[n.a] * known[n.b];
  if (n.op == operation::abs) return square(known[n.a]);
  if (n.op == operation::sqrt) return {known[n.a].least > 0 ? 1 : 0, 1};
  if (n.op == operation::exp) return {1, 1};
  return {};
}

} // namespace detail

/// Whether an expression is positive, or negative, whatever the values of its symbols are, as x² + 1 is.
/// False if this does not follow from the signs of its parts.
constexpr bool has_definite_sign(expression e) {
  const graph& g = e.owner();
  base::sequence<detail::sign_range> known(e.node() + 1);
  for (const int id : live_values(g, {e.node()})) known[id] = detail::sign_of_node(g, id, known);
  return known[e.node()].least > 0 || known[e.node()].greatest < 0;
}

} // namespace kanexpr::symbolic
