#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/external.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/list.hpp>
#include <kanexpr/symbolic/limits/series.hpp>

#include <vector>

/// User-defined functions. Only their derivatives are known, so they get generic values even where their
/// operands are numbers.
namespace kanexpr::symbolic::limits {

/// The generic values of a call.
inline generic_values call_values(const external_function& f, const std::vector<generic_values>& operands) {
  return generic_values::by(false, [&](int i) {
    std::vector<double> at;
    for (const generic_values& each : operands) {
      if (!each[i].defined()) return bounded::undefined();
      at.push_back(each[i].value);
    }
    double error = 0;
    for (std::size_t k = 0; k < operands.size(); ++k)
      error += std::abs(substitute_value(f.slope(static_cast<int>(k)), at.data())) * operands[k][i].error;
    return bounded::rounded(substitute_value(f, at.data()), error);
  });
}

/// The constant coefficient of a call.
inline coefficient call_coefficient(graph& g, const external_function& f,
                                    const std::vector<series>& operands) {
  sequence<int> nodes;
  std::vector<generic_values> values;
  for (const series& each : operands) {
    nodes.push(each[0].in(g).node());
    values.push_back(each[0].at());
  }
  return {expression{g, call(g, f, list_of(g, nodes))}, call_values(f, values)};
}

/// The series of a call with the requested number of terms, or fewer if there are not enough derivatives.
inline series call_series(graph& g, const external_function& f, const std::vector<series>& operands,
                          int terms, int most) {
  const coefficient first = call_coefficient(g, f, operands);
  if (terms <= 1) return {0, {first}, 1, most};
  series rate;
  for (std::size_t i = 0; i < operands.size(); ++i) {
    if (operands[i].is_constant()) continue;
    const external_function& slope = f.slope(static_cast<int>(i));
    if (!slope.is_provided()) return {0, {first}, 1, most};
    const series by_operand = call_series(g, slope, operands, terms - 1, most);
    rate = rate + by_operand * derivative(operands[i]);
  }
  return integral(rate, first);
}

/// The series of a call, given those of its operands.
inline expansion expand_call(graph& g, const external_function& f, const std::vector<series>& operands,
                             int most) {
  int terms = 1;
  for (const series& each : operands) {
    if (each.has_terms() && each.order() < 0) return obstacle::infinite_argument;
    if (each.end() <= 0) return obstacle::truncated;
    if (!each.is_constant()) terms = (std::max)(terms, (std::min)(each.computed_end(), most + 1));
  }
  return call_series(g, f, operands, terms, most);
}

} // namespace kanexpr::symbolic::limits
