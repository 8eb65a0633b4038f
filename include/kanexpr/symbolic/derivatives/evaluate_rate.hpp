#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/evaluate.hpp>
#include <kanexpr/symbolic/graph/external.hpp>
#include <kanexpr/symbolic/graph/function_table.hpp>
#include <kanexpr/symbolic/graph/functions.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

namespace kanexpr::symbolic {

/// A number and its time derivative.
struct value_and_rate {
  double value = 0;
  double rate = 0;

  static constexpr value_and_rate undefined() {
    return {numeric::elementary::detail::not_a_number, numeric::elementary::detail::not_a_number};
  }
  /// The result of an operation, given the values of the nodes; linear systems are undefined.
  static constexpr value_and_rate at_node(const graph& g, int id, const value_and_rate* value);

private:
  static constexpr value_and_rate of_call(const external_function& f, const sequence<int>& given,
                                          const value_and_rate* value);
};

/// Applies an operation to numbers that change with time. Undefined results are NaN; the caller must check
/// for them.
constexpr value_and_rate evaluate_with_rate(operation op, value_and_rate a, value_and_rate b) {
  const double value = value_of(op, a.value, b.value);
  if (!is_selection(op) && !numeric::elementary::detail::is_finite(value))
    return {value, numeric::elementary::detail::not_a_number}; // constant expressions cannot compute with NaN
  const auto along = [&](double by_a) {
    return value_and_rate{value, base::equal(by_a, 0.0) ? 0 : by_a * a.rate};
  };
  switch (form_of(op)) {
  case form::negate: return along(-1);
  case form::add: return {value, a.rate + b.rate};
  case form::subtract: return {value, a.rate - b.rate};
  case form::multiply: return {value, a.rate * b.value + a.value * b.rate};
  case form::divide: return {value, (a.rate - value * b.rate) / b.value};
  case form::power:
    return {
        value,
        (base::equal(a.rate, 0.0) ? 0 : b.value * numeric::elementary::pow(a.value, b.value - 1) * a.rate) +
            (base::equal(b.rate, 0.0) ? 0 : value * numeric::elementary::log(a.value) * b.rate)};
  case form::function:
    return along(properties_of(op).is_smooth_at(a.value) ? slope_of(op, a.value, value)
                                                         : numeric::elementary::detail::not_a_number);
  case form::binary_function:
    return {value, with_binary_function(op, [&]<operation function>() {
              return binary_rate_of<function>(a.value, b.value, value, a.rate, b.rate);
            })};
  case form::selection: return {value, selected(op, a.value, b.rate)};
  case form::leaf:
  case form::list_operation: break; // not operations on two numbers
  }
  return {value, numeric::elementary::detail::not_a_number};
}

constexpr bool is_finite(const value_and_rate& x) { return is_finite(x.value) && is_finite(x.rate); }

constexpr value_and_rate value_and_rate::at_node(const graph& g, int id, const value_and_rate* value) {
  const node& n = g[id];
  if (n.op == operation::call) return of_call(g.external_at(id), elements_of(g, n.a), value);
  if (n.op >= operation::pair) return undefined();
  const value_and_rate &a = value[n.a], b = is_binary(n.op) ? value[n.b] : value_and_rate{};
  // constant expressions reject undefined operands and a zero divisor, except where a selection discards them
  const bool is_defined =
      is_finite(a) && is_finite(b) && !(n.op == operation::divide && base::equal(b.value, 0.0)) &&
      !(is_binary_function(n.op) && !binary_properties_of(n.op).is_smooth_at(a.value, b.value));
  return is_defined || is_selection(n.op) ? evaluate_with_rate(n.op, a, b) : undefined();
}

constexpr value_and_rate value_and_rate::of_call(const external_function& f, const sequence<int>& given,
                                                 const value_and_rate* value) {
  sequence<double> operands;
  for (int each : given) {
    if (!is_finite(value[each])) return undefined();
    operands.push(value[each].value);
  }
  value_and_rate found{substitute_value(f, operands.begin()), 0};
  for (int i = 0; i < operands.size(); ++i)
    found.rate += substitute_value(f.slope(i), operands.begin()) * value[given[i]].rate;
  return found;
}

/// Evaluates outputs and their time derivatives without building expressions for the derivatives.
using rate_evaluation = basic_evaluation<value_and_rate>;

} // namespace kanexpr::symbolic
