#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/functions.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

namespace kanexpr::symbolic {

/// The size of the terms of a sum: |l cos(q1)| + |l0| for l cos(q1) - l0. Relative to this size, a sum that
/// should vanish can be tested in any units.
class term_sizes {
public:
  constexpr explicit term_sizes(graph& g) : g_(g), found_(g.size(), none) {}

  constexpr expression of(const expression& e) {
    const int id = e.node();
    if (found_[id] == none) found_[id] = form(e).node();
    return {g_, found_[id]};
  }

private:
  static constexpr int none = -1;

  constexpr expression form(const expression& e) {
    const node n = g_[e.node()]; // a copy, because the graph grows
    const expression a(g_, n.a), b(g_, is_binary(n.op) && n.op < operation::pair ? n.b : n.a);
    if (n.op == operation::negate) return of(a);
    if (n.op == operation::multiply) return product(a, b);
    if (n.op != operation::add && n.op != operation::subtract && n.op != operation::divide) return abs(e);
    const expression first = of(a);
    return n.op == operation::divide ? first / abs(b) : first + of(b);
  }

  /// The size of a product to first order, which keeps the residues of nearly vanishing sums from growing
  /// from one product to the next.
  constexpr expression product(const expression& a, const expression& b) {
    const expression left = abs(a), right = abs(b);
    if (of(a).node() == left.node()) return left * of(b);
    if (of(b).node() == right.node()) return of(a) * right;
    const expression by_a = of(a) * right;
    return by_a + left * (of(b) - right);
  }

  graph& g_;
  sequence<int> found_; ///< by node
};

/// The magnitudes of the terms in several sums.
constexpr sequence<expression> terms_of(graph& g, const sequence<expression>& sums) {
  term_sizes sizes(g);
  sequence<expression> terms;
  for (const expression& f : sums) terms.push(sizes.of(f));
  return terms;
}

} // namespace kanexpr::symbolic
