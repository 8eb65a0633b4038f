#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/numeric/elementary.hpp>
#include <kanexpr/numeric/elimination.hpp>
#include <kanexpr/symbolic/graph/function_table.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/list.hpp>
#include <kanexpr/symbolic/graph/live_nodes.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

#include <type_traits>
#include <utility>

namespace kanexpr::symbolic {

/// Evaluates one operation in a constant expression, where the C library is not available.
constexpr double value_of(operation op, double a, double b) {
  switch (form_of(op)) {
  case form::negate: return -a;
  case form::add: return a + b;
  case form::subtract: return a - b;
  case form::multiply: return a * b;
  case form::divide: return a / b;
  case form::power: return numeric::elementary::pow(a, b);
  case form::function: return properties_of(op).value(a);
  case form::binary_function: return binary_properties_of(op).value(a, b);
  case form::selection: return selected(op, a, b);
  case form::leaf:
  case form::list_operation: break; // not operations on two numbers
  }
  return numeric::elementary::detail::not_a_number;
}

/// Like `value_of`, but accepts undefined operands and a zero divisor, which constant expressions reject. The
/// result is then NaN, unless the operation is a selection that does not select the operand.
constexpr double defined_value_of(operation op, double a, double b) {
  if (is_selection(op)) return selected(op, a, b);
  if (!base::is_number(a) || !base::is_number(b) || (op == operation::divide && base::equal(b, 0.0)))
    return numeric::elementary::detail::not_a_number;
  return value_of(op, a, b);
}

/// Evaluates the nodes that the outputs need, for any number of sets of symbol values. Undefined values (0/0,
/// the solution of a singular system) are NaN and propagate. Calls to user-defined functions get generic
/// values, which are consistent with their derivatives. `Number` is double, or a class whose `at_node`
/// computes the result of an operation from the values of the nodes.
template <class Number>
class basic_evaluation {
public:
  constexpr basic_evaluation(const graph& g, const sequence<int>& outputs)
      : g_(g), live_(live_values(g, outputs)), value_(live_.empty() ? 0 : live_.back() + 1, Number{0}) {
    if (has_systems && g.has_lists()) place_.resize(value_.size(), 0);
  }

  /// `value_of_symbol(id)` returns the value of the symbol at node `id`.
  template <class ValueOfSymbol>
  constexpr void at(ValueOfSymbol value_of_symbol) {
    more_.clear();
    const node* const nodes = g_.begin(); // a pointer, because compilers interpret every call to operator[]
    Number* const value = value_.begin();
    for (int id : live_) {
      const node& n = nodes[id];
      if (n.op == operation::constant)
        value[id] = Number{g_.number_at(id).value()};
      else if (n.op == operation::symbol)
        value[id] = value_of_symbol(id);
      else if constexpr (!has_systems)
        value[id] = Number::at_node(g_, id, value);
      else if (n.op < operation::pair)
        value[id] = defined_value_of(n.op, value[n.a], is_binary(n.op) ? value[n.b] : 0.0);
      else
        value[id] = solving(id, n);
    }
  }

  constexpr const Number& operator[](int id) const { return value_[id]; }
  /// The evaluated nodes, in ascending order.
  constexpr const sequence<int>& live() const { return live_; }

private:
  static constexpr bool has_systems = std::is_same_v<Number, double>;
  static constexpr double undefined = numeric::elementary::detail::not_a_number;

  /// Appends the values of a list and returns whether all are defined.
  constexpr bool gather(int list) {
    bool all = true;
    for (; g_[list].op == operation::pair; list = g_[list].b) {
      const double value = value_[g_[list].a];
      all = all && base::is_number(value);
      more_.push(value);
    }
    return all;
  }

  constexpr double solving(int id, const node& n) {
    if (n.op == operation::component) return more_[place_[n.a] + integer_at(g_, n.b)];
    if (n.op == operation::call) {
      const int first = more_.size();
      return gather(n.a) ? substitute_value(g_.external_at(id), &more_[first]) : undefined;
    }
    const int factorization = n.op == operation::factorization ? id : n.a;
    const int order = order_of(g_, factorization), first = more_.size();
    const numeric::factors place{order};
    place_[id] = first;
    if (n.op == operation::factorization) {
      bool all = true;
      for (int rows = n.a; g_[rows].op == operation::pair; rows = g_[rows].b) all = gather(g_[rows].a) && all;
      more_.resize(first + place.size(), 0);
      if (all)
        numeric::factorize<numeric::constant_elimination_math>(order, &more_[first]);
      else
        more_[first + place.least_pivot()] = undefined;
      return 0;
    }
    const bool all = gather(n.b);
    const double* const f = &more_[place_[n.a]];
    const double least = f[place.least_pivot()];
    if (n.op == operation::singularity_measure)
      return all && base::is_number(least) ? singularity_measure(order, f, first) : undefined;
    if (!all || !(least > 0)) {
      for (int i = 0; i < order; ++i) more_[first + i] = undefined;
    } else if (n.op == operation::solve) {
      numeric::solve_factorized<numeric::constant_elimination_math>(order, f, &more_[first]);
    } else {
      numeric::solve_transposed_factorized<numeric::constant_elimination_math>(order, f, &more_[first]);
    }
    return 0;
  }

  constexpr double singularity_measure(int order, const double* f, int squares) {
    if (base::equal(f[numeric::factors{order}.least_pivot()], 0.0)) return 0;
    if (order > max_cofactor_order)
      return numeric::singularity_measure_of<numeric::constant_elimination_math>(order, f, &more_[squares]);
    double inverse = 1;
    for (int i = 0; i < order; ++i) inverse *= f[numeric::factors{order}.at(i, i)];
    return 1 / numeric::elementary::abs(inverse);
  }

  const graph& g_;
  sequence<int> live_;
  sequence<Number> value_;
  sequence<double> more_{}; ///< factors and solutions
  sequence<int> place_{};   ///< for each node, where its values start in `more_`
};

using evaluation = basic_evaluation<double>;

/// The values of the outputs; `value_of_symbol(id)` returns the value of the symbol at node `id`.
template <class ValueOfSymbol>
constexpr sequence<double> values_at(const graph& g, const sequence<int>& outputs,
                                     ValueOfSymbol value_of_symbol) {
  evaluation all(g, outputs);
  all.at(value_of_symbol);
  sequence<double> values;
  for (int id : outputs) values.push(all[id]);
  return values;
}

} // namespace kanexpr::symbolic
