#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/constraints/constraints.hpp>
#include <kanexpr/mechanics/constraints/partition.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>

namespace kanexpr::mechanics {

/// The dependent speeds and their rates in terms of the independent ones: u_d = A u_i + b, u̇_d = A u̇_i +
/// b̄. If a constraint is not linear in the speeds, A depends on them and b is a Newton step of u_d.
struct dependent_speeds {
  symbolic::matrix on_independent{};        ///< A
  sequence<expression> at_rest{};           ///< b, or the Newton step
  sequence<expression> acceleration_bias{}; ///< b̄
  sequence<symbolic::solved_block> blocks{};
};

constexpr symbolic::matrix transposed(graph& g, const symbolic::matrix& a) {
  symbolic::matrix out(g, a.columns, a.rows);
  for (int i = 0; i < a.rows; ++i)
    for (int j = 0; j < a.columns; ++j) out(j, i) = a(i, j);
  return out;
}

/// A x + b: the dependent speeds or their rates, with x the independent ones.
constexpr sequence<expression> solved_for_dependent(const symbolic::matrix& on_independent,
                                                    const sequence<expression>& independent,
                                                    sequence<expression> bias) {
  for (int d = 0; d < bias.size(); ++d)
    for (int i = 0; i < independent.size(); ++i) bias[d] += on_independent(d, i) * independent[i];
  return bias;
}

namespace detail {

constexpr symbolic::matrix columns_of(graph& g, const symbolic::matrix& a, const sequence<int>& columns) {
  symbolic::matrix out(g, a.rows, columns.size());
  for (int i = 0; i < a.rows; ++i)
    for (int j = 0; j < columns.size(); ++j) out(i, j) = a(i, columns[j]);
  return out;
}

/// The sums from which the constraints on the speeds are formed.
constexpr sequence<int> sums_that_bind(const mechanism& m, const constraints& c) {
  sequence<int> sums = symbolic::nodes_of(m.kinematics);
  for (const expression& e : c.on_configuration) sums.push(e.node());
  for (const velocity_constraint& v : c.on_velocities) sums.push(v.value.node());
  return sums;
}

} // namespace detail

/// Marks the speeds that are the rates of dependent coordinates, which are preferred as dependent speeds.
constexpr sequence<char> rates_of_dependent(const skeleton& s, const partition& coordinates) {
  const sequence<expression>& speeds = s.model->speeds;
  sequence<char> preferred(speeds.size(), 0);
  for (int j : coordinates.dependent)
    for (int i = 0; i < speeds.size(); ++i)
      if (s.coordinate_rates[j] == speeds[i]) preferred[i] = 1;
  return preferred;
}

/// Solves the constraints J u + c = 0 and J u̇ + γ = 0, with `bias` = γ, with one factorization for all
/// right-hand sides. If a constraint φ is not linear, J Δu = −φ replaces the first of these equations.
constexpr dependent_speeds solve_for_dependent_speeds(const mechanism& m, const constraints& c,
                                                      const partition& speeds,
                                                      const sequence<expression>& bias) {
  graph& g = *m.g;
  const int rows = c.size(), free = speeds.independent.size();
  symbolic::matrix right(g, rows, free + 2);
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < free; ++j) right(i, j) = -c.jacobian(i, speeds.independent[j]);
    right(i, free) = -(c.nonlinear == 0 ? c.remainder[i] : c.on_velocities[i].value);
    right(i, free + 1) = -bias[i];
  }
  const symbolic::linear_solution solved =
      symbolic::solve_linear(g, detail::columns_of(g, c.jacobian, speeds.dependent), right, c.jacobian,
                             detail::sums_that_bind(m, c));
  dependent_speeds out{symbolic::matrix(g, rows, free), {}, {}, solved.blocks};
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < free; ++j) out.on_independent(i, j) = solved.x(i, j);
    out.at_rest.push(solved.x(i, free));
    out.acceleration_bias.push(solved.x(i, free + 1));
  }
  return out;
}

} // namespace kanexpr::mechanics
