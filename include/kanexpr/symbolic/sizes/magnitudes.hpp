#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/evaluate.hpp>
#include <kanexpr/symbolic/graph/function_table.hpp>
#include <kanexpr/symbolic/graph/functions.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

namespace kanexpr::symbolic {

/// The magnitudes of the terms that add up to each value, to first order in the rounding errors (Higham 2002,
/// section 3.3). A value far below this magnitude is zero up to rounding, whatever its unit.
class magnitudes {
public:
  /// Uses the values of the last evaluation.
  constexpr magnitudes(const graph& g, const evaluation& value) : g_(g) {
    if (value.live().empty()) return;
    size_.resize(value.live().back() + 1, 0.0);
    for (int id : value.live()) size_[id] = size_of(id, value);
  }

  constexpr double operator[](int id) const { return size_[id]; }

  /// Whether a value has no reliable digits, even if its constants are accurate to only ten digits.
  constexpr bool is_rounding_residue(int id, double value) const {
    return numeric::elementary::abs(value) <= negligible * size_[id];
  }

private:
  static constexpr double negligible = 1e-10;

  constexpr double size_of(int id, const evaluation& value) {
    const node& n = g_[id];
    const double v = numeric::elementary::abs(value[id]);
    switch (form_of(n.op)) {
    case form::leaf: return v;
    case form::negate: return size_[n.a];
    case form::add:
    case form::subtract: return size_[n.a] + size_[n.b];
    case form::multiply:
      return size_[n.a] * numeric::elementary::abs(value[n.b]) +
             numeric::elementary::abs(value[n.a]) * size_[n.b];
    case form::divide: return over(size_[n.a], value[n.b]) + v * over(size_[n.b], value[n.b]);
    case form::power: return v * (1 + over(size_[n.a], value[n.a]));
    case form::function: return size_of_function(n.op, size_[n.a], value[n.a], value[id]);
    case form::binary_function: return size_of_binary_function(n, value, value[id]);
    case form::selection: return selected(n.op, value[n.a], size_[n.b]);
    case form::list_operation: return size_of_list_operation(id, value);
    }
    return v;
  }

  constexpr double size_of_list_operation(int id, const evaluation& value) {
    const node& n = g_[id];
    const double v = numeric::elementary::abs(value[id]);
    if (n.op == operation::component) return solutions_[first_of(n.a) + integer_at(g_, n.b)];
    if (n.op == operation::singularity_measure) return v;
    if (n.op == operation::call) return v + slopes_times_terms(id, value);
    if (is_solution(n.op)) solve(id, value);
    return 0;
  }

  /// The size of f(x) plus that of its derivative times the terms of x; the derivative of a sine counts as 1
  /// everywhere.
  static constexpr double size_of_function(operation op, double terms, double x, double f) {
    const double v = numeric::elementary::abs(f);
    if (op == operation::abs) return terms;
    if (op == operation::sqrt) return over(terms, v);
    if (op == operation::cos) return v + terms * (terms < 1 ? terms : 1);
    if (properties_of(op).is_trigonometric || op == operation::sign) return v + terms;
    return v + (properties_of(op).is_smooth_at(x) ? numeric::elementary::abs(slope_of(op, x, f)) * terms : 0);
  }

  /// f(a, b) plus its derivatives times the terms of a and b; the derivatives of an angle count as 1 and 0.
  constexpr double size_of_binary_function(const node& n, const evaluation& value, double f) const {
    const binary_function_properties& of = binary_properties_of(n.op);
    const double v = numeric::elementary::abs(f), a = value[n.a], b = value[n.b];
    if (of.is_trigonometric) return v + size_[n.a];
    if (!of.is_smooth_at(a, b)) return v;
    const binary_slopes<double> by = binary_slopes_of(n.op, a, b, f);
    return v + numeric::elementary::abs(by.by_a) * size_[n.a] +
           numeric::elementary::abs(by.by_b) * size_[n.b];
  }

  /// The derivatives of a call times the terms of its operands.
  constexpr double slopes_times_terms(int id, const evaluation& value) const {
    const sequence<int> operands = elements_of(g_, g_[id].a);
    sequence<double> at;
    for (int each : operands) at.push(value[each]);
    double sum = 0;
    for (int i = 0; i < operands.size(); ++i)
      sum += numeric::elementary::abs(substitute_value(g_.external_at(id).slope(i), at.begin())) *
             size_[operands[i]];
    return sum;
  }

  static constexpr double over(double a, double b) {
    return base::equal(b, 0.0) ? 0 : a / numeric::elementary::abs(b);
  }

  /// |A⁻¹| (|A| |x| + |b|) for the solution x.
  constexpr void solve(int id, const evaluation& value) {
    const node& n = g_[id];
    const int order = order_of(g_, n.a);
    const sequence<int> entries = entries_of(g_, n.a), right = elements_of(g_, n.b);
    const auto entry = [&](int i, int j) {
      return entries[n.op == operation::solve ? i * order + j : j * order + i];
    };
    const numeric::factors place{order};
    sequence<double> f(place.size(), 0.0), x(order, 0.0), terms(order, 0.0);
    for (int i = 0; i < order; ++i)
      for (int j = 0; j < order; ++j) f[place.at(i, j)] = value[entry(i, j)];
    numeric::factorize<numeric::constant_elimination_math>(order, &f[0]);
    for (int i = 0; i < order; ++i) x[i] = value[right[i]];
    numeric::solve_factorized<numeric::constant_elimination_math>(order, &f[0], &x[0]);
    for (int i = 0; i < order; ++i) {
      terms[i] = size_[right[i]];
      for (int j = 0; j < order; ++j) terms[i] += size_[entry(i, j)] * numeric::elementary::abs(x[j]);
    }
    const int first = solutions_.size();
    solved_.push(id), places_.push(first);
    solutions_.resize(first + order, 0.0);
    for (int j = 0; j < order; ++j) {
      sequence<double> unit(order, 0.0);
      unit[j] = 1;
      numeric::solve_factorized<numeric::constant_elimination_math>(order, &f[0], &unit[0]);
      for (int i = 0; i < order; ++i) solutions_[first + i] += numeric::elementary::abs(unit[i]) * terms[j];
    }
  }
  constexpr int first_of(int solution) const {
    int i = solved_.size() - 1;
    while (solved_[i] != solution) --i;
    return places_[i];
  }

  const graph& g_;
  sequence<double> size_{}, solutions_{};
  sequence<int> solved_{}, places_{}; ///< solve nodes and the start of their solutions
};

} // namespace kanexpr::symbolic
