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

/// Like `evaluate_with_rate`, but accepts undefined operands and a zero divisor, which constant expressions
/// reject. The result is then NaN, unless the operation is a selection that does not select the operand.
constexpr value_and_rate defined_value_of(operation op, const value_and_rate& a, const value_and_rate& b) {
  const bool is_defined =
      is_finite(a) && is_finite(b) && !(op == operation::divide && base::equal(b.value, 0.0)) &&
      !(is_binary_function(op) && !binary_properties_of(op).is_smooth_at(a.value, b.value));
  return is_defined || is_selection(op) ? evaluate_with_rate(op, a, b) : value_and_rate::undefined();
}

/// The generic value of a call, given the values by node; linear systems are undefined.
constexpr value_and_rate value_of_list_operation(const graph& g, int id, const value_and_rate* value) {
  if (g[id].op != operation::call) return value_and_rate::undefined();
  const external_function& f = g.external_at(id);
  const sequence<int> given = elements_of(g, g[id].a);
  sequence<double> operands;
  for (int each : given) {
    if (!is_finite(value[each])) return value_and_rate::undefined();
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
