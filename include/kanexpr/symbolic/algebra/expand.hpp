#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/algebra/expansion_reader.hpp>
#include <kanexpr/symbolic/algebra/forms.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>

#include <vector>

namespace kanexpr::symbolic {

KANEXPR_ENGINE rewritten expand(expression e, std::size_t most_terms) {
  return algebra::rewrite<algebra::expansion_reader>(e, most_terms,
                                                     "the expression cannot be multiplied out: ");
}

KANEXPR_ENGINE rewritten collect(expression e, const sequence<expression>& by, std::size_t most_terms) {
  graph& g = e.owner();
  algebra::budget left(most_terms);
  sequence<int> outputs{e.node()};
  for (const expression& each : by) outputs.push(each.node());
  const auto sums = algebra::expansion_reader(g, left).read(outputs);
  if (left.failed()) return {e, "the expression cannot be multiplied out: " + left.cause()};
  std::vector<int> bases;
  for (std::size_t i = 1; i < sums.size(); ++i) {
    const bool is_power = sums[i].size() == 1 && sums[i].terms[0].factors.size() == 1;
    if (!is_power || sums[i].terms[0].factors[0].exponent != 1)
      return {
          e, "an expression can be collected only by symbols and functions, not by sums, products or powers"};
    bases.push_back(sums[i].terms[0].factors[0].base);
  }
  const auto is_collected = [&bases](int base) { return std::ranges::find(bases, base) != bases.end(); };
  expression sum(g, graph::zero);
  for (const auto& [powers, coefficient] : coefficients(sums.front(), is_collected)) {
    const bool negative = algebra::is_all_negative(coefficient);
    const expression magnitude = algebra::to_expression(g, negative ? -coefficient : coefficient);
    const expression numerator = magnitude * algebra::one_sided_product(g, powers, 1);
    const expression term = numerator / algebra::one_sided_product(g, powers, -1);
    sum = negative ? sum - term : sum + term;
  }
  return {sum, {}};
}

} // namespace kanexpr::symbolic
