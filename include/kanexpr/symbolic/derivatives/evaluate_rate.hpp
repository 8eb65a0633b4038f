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
struct rated {
  double value = 0;
  double rate = 0;
};

/// Applies an operation to numbers that change with time. Undefined results are NaN; the caller must check
/// for them.
constexpr rated rated_value_of(operation op, rated a, rated b) {
  const double value = value_of(op, a.value, b.value);
  if (!is_selection(op) && !numeric::elementary::detail::is_finite(value))
    return {value, numeric::elementary::detail::not_a_number}; // constant expressions cannot compute with NaN
  const auto along = [&](double by_a) { return rated{value, base::equal(by_a, 0.0) ? 0 : by_a * a.rate}; };
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
  case form::constant:
  case form::symbol:
  case form::pair:
  case form::factorization:
  case form::solve:
  case form::transposed_solve:
  case form::component:
  case form::singularity_measure:
  case form::call: break; // not operations on two numbers
  }
  return {value, numeric::elementary::detail::not_a_number};
}

/// Evaluates outputs and their time derivatives without building expressions for the derivatives.
class rate_evaluation {
public:
  constexpr rate_evaluation(const graph& g, const sequence<int>& outputs) : g_(g), at_(g.size()) {
    const sequence<char> live = live_nodes(g, outputs);
    for (int id = 0; id < g.size(); ++id)
      if (live[id] != 0) live_.push(id);
  }

  /// `of_symbol(id)` returns the value and rate of the symbol at node `id`.
  template <class OfSymbol>
  constexpr void at(OfSymbol of_symbol) {
    for (int id : live_) {
      const node& n = g_[id];
      if (n.op == operation::constant)
        at_[id] = {g_.number_at(id).value(), 0};
      else if (n.op == operation::symbol)
        at_[id] = of_symbol(id);
      else if (n.op == operation::call)
        at_[id] = called(id);
      else
        at_[id] = n.op < operation::pair ? defined(n.op, at_[n.a], is_binary(n.op) ? at_[n.b] : rated{})
                                         : undefined;
    }
  }

  constexpr const rated& operator[](int id) const { return at_[id]; }

private:
  static constexpr rated undefined{numeric::elementary::detail::not_a_number,
                                   numeric::elementary::detail::not_a_number};

  // A constant expression must not divide by zero.
  static constexpr rated defined(operation op, rated a, rated b) {
    if (is_selection(op)) return rated_value_of(op, a, b); // the other branch may be undefined
    if (!is_finite(a) || !is_finite(b)) return undefined;
    if (op == operation::divide && base::equal(b.value, 0.0)) return undefined;
    if (is_binary_function(op) && !binary_properties_of(op).is_smooth_at(a.value, b.value)) return undefined;
    return rated_value_of(op, a, b);
  }
  constexpr rated called(int id) const {
    const external_function& f = g_.external_at(id);
    const sequence<int> given = elements_of(g_, g_[id].a);
    sequence<double> operands;
    for (int each : given) {
      if (!is_finite(at_[each])) return undefined;
      operands.push(at_[each].value);
    }
    rated found{generic_value_of(f, operands.begin()), 0};
    for (int i = 0; i < operands.size(); ++i)
      found.rate += generic_value_of(f.slope(i), operands.begin()) * at_[given[i]].rate;
    return found;
  }
  static constexpr bool is_finite(rated x) {
    return numeric::elementary::detail::is_finite(x.value) && numeric::elementary::detail::is_finite(x.rate);
  }

  const graph& g_;
  sequence<int> live_{}; ///< in ascending order
  sequence<rated> at_;
};

} // namespace kanexpr::symbolic
