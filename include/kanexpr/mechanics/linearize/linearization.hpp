#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/linearize/general_form.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/linear/solve_linear.hpp>

namespace kanexpr::mechanics {

/// M δ[q̇; u̇; λ] = A δ[q_i; u_i] + B δr, with the rows in the order kinematics, constraints, dynamics.
struct implicit_linearization {
  symbolic::matrix mass{};  ///< M, (n+o+k)×(n+o+k)
  symbolic::matrix state{}; ///< A, (n+o+k)×(n−l+o−m)
  symbolic::matrix input{}; ///< B, (n+o+k)×s
};

/// δ[q̇_i; u̇_i] = A δ[q_i; u_i] + B δr; for outputs y, δy = C δ[q_i; u_i] + D δr.
struct explicit_linearization {
  symbolic::matrix state{}; ///< A or C
  symbolic::matrix input{}; ///< B or D

  constexpr explicit_linearization() = default;
  constexpr explicit_linearization(graph& g, int rows, int states, int inputs)
      : state(g, rows, states), input(g, rows, inputs) {}

  template <class Self, class Visit>
  static constexpr void each_member(Self& self, Visit&& visit) {
    visit(self.state, self.input);
  }

  /// The entry (i, j); columns of the state come first, followed by those of the inputs.
  constexpr expression& operator()(int i, int j) {
    return j < state.columns ? state(i, j) : input(i, j - state.columns);
  }
  constexpr const expression& operator()(int i, int j) const {
    return j < state.columns ? state(i, j) : input(i, j - state.columns);
  }
};

/// δ[q̇; u̇; λ] = M⁻¹ (A δ[q_i; u_i] + B δr), a column for each state, followed by one for each input.
constexpr symbolic::linear_solution solve_for_rates(graph& g, const implicit_linearization& given) {
  symbolic::matrix right(g, given.state.rows, given.state.columns + given.input.columns);
  for (int i = 0; i < right.rows; ++i)
    for (int j = 0; j < right.columns; ++j)
      right(i, j) = j < given.state.columns ? given.state(i, j) : given.input(i, j - given.state.columns);
  return symbolic::solve_linear(g, given.mass, right);
}

/// Returns the given rows of `changes`; its last `inputs` columns belong to the inputs.
constexpr explicit_linearization rows_of(graph& g, const symbolic::matrix& changes, const sequence<int>& rows,
                                         int inputs) {
  explicit_linearization out(g, rows.size(), changes.columns - inputs, inputs);
  for (int i = 0; i < rows.size(); ++i)
    for (int j = 0; j < changes.columns; ++j) out(i, j) = changes(rows[i], j);
  return out;
}

/// The rows of the independent coordinates and speeds among those of [q; u].
constexpr explicit_linearization rows_of_states(graph& g, const general_form& form,
                                                const symbolic::matrix& rates) {
  sequence<int> rows = form.coordinates.independent;
  for (int i : form.speeds.independent) rows.push(form.q.size() + i);
  return rows_of(g, rates, rows, form.inputs());
}

/// P in [q; u; λ] = P [q_i; u_i; q_d; u_d; λ].
constexpr symbolic::matrix permutation_of(graph& g, const general_form& form) {
  symbolic::matrix p(g, form.unknowns(), form.unknowns());
  int column = 0;
  const auto put = [&](const sequence<int>& places, int first) {
    for (int i : places) p(first + i, column++) = {g, graph::one};
  };
  put(form.coordinates.independent, 0);
  put(form.speeds.independent, form.q.size());
  put(form.coordinates.dependent, 0);
  put(form.speeds.dependent, form.q.size());
  for (; column < p.columns; ++column) p(column, column) = {g, graph::one};
  return p;
}

} // namespace kanexpr::mechanics
