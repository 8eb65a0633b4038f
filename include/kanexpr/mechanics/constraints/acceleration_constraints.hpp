#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/constraints/consistent_states.hpp>
#include <kanexpr/mechanics/constraints/dependent_speeds.hpp>
#include <kanexpr/mechanics/model/check_contents.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/wording.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

/// Acceleration constraints that the model specifies instead of the derivatives of its velocity constraints.
namespace kanexpr::mechanics {

/// J_a u̇ + γ_a = 0.
struct linear_accelerations {
  symbolic::matrix jacobian;
  sequence<expression> bias;
};

constexpr linear_accelerations linear_in_speed_rates(const skeleton& s, const constraints& c) {
  const mechanism& m = *s.model;
  known_rates known(m, s.coordinate_rates);
  symbolic::substitution at_rest(*m.g);
  for (const expression& rate : m.speed_rates) at_rest.replace(rate, m.zero());
  linear_accelerations out{symbolic::matrix(*m.g, c.on_accelerations.size(), m.speeds.size()), {}};
  symbolic::differentiation by_rate(*m.g);
  for (int j = 0; j < m.speeds.size(); ++j) {
    by_rate.restart();
    by_rate.set_rate(m.speed_rates[j], m.one());
    for (int i = 0; i < out.jacobian.rows; ++i)
      out.jacobian(i, j) = known.in(by_rate.of(c.on_accelerations[i]));
  }
  for (const expression& e : c.on_accelerations) out.bias.push(at_rest.in(known.in(e)));
  return out;
}

/// Returns b̄ in u̇_d = A u̇_i + b̄.
constexpr symbolic::linear_solution solve_acceleration_constraints(graph& g, const linear_accelerations& a,
                                                                   const partition& speeds) {
  symbolic::matrix right(g, a.jacobian.rows, 1);
  for (int i = 0; i < right.rows; ++i) right(i, 0) = -a.bias[i];
  return symbolic::solve_linear(g, detail::columns_of(g, a.jacobian, speeds.dependent), right, a.jacobian);
}

/// Checks that the acceleration constraints restrict the rates of the speeds as the other constraints
/// restrict the speeds, and that they hold wherever the other constraints hold.
constexpr sentence check_acceleration_constraints(const skeleton& s, const constraints& c,
                                                  const symbolic::matrix& configuration) {
  const mechanism& m = *s.model;
  if (c.on_accelerations.empty()) return {};
  const contents held(*m.g);
  for (int i = 0; i < c.on_accelerations.size(); ++i) {
    const expression e = c.on_accelerations[i];
    const name which = base::counted(i + 1);
    if (!held.holds(e, symbolic::symbol_kind::speed_rate))
      return sentence({"acceleration constraint ", which.view(),
                       m.derived_by == method::kane ? " contains no rate of a speed"
                                                    : " contains no second derivative of a coordinate"});
    if (const sentence found = check_no_state_variable(m, held, e, "acceleration constraint ", which.view()))
      return found;
    if (const sentence found = symbol_in(m, held, e, {symbolic::symbol_kind::auxiliary_speed}))
      return sentence({"acceleration constraint ", which.view(), " contains the ", found.view()});
    for (const expression& rate : m.speed_rates)
      if (const expression slope = symbolic::differentiate(e, rate);
          contents(*m.g).holds(slope, symbolic::symbol_kind::speed_rate))
        return sentence({"acceleration constraint ", which.view(), " is not linear in the ",
                         speed_rate_called(m, called(m, rate)).view()});
  }
  if (c.on_accelerations.size() != c.size())
    return sentence({several(c.on_accelerations.size(), "acceleration constraint").view(), " for ",
                     several(c.size(), "constraint", " on the velocities").view(),
                     "; the numbers must be equal"});
  const symbolic::matrix given = linear_in_speed_rates(s, c).jacobian;
  symbolic::matrix all(*m.g, 2 * c.size(), m.speeds.size());
  for (int i = 0; i < all.rows; ++i)
    for (int j = 0; j < all.columns; ++j)
      all(i, j) = i < c.size() ? c.jacobian(i, j) : given(i - c.size(), j);
  const sequence<char> adds = independent_rows(all, s.model);
  for (int i = 0; i < c.size(); ++i)
    if (adds[c.size() + i] != 0)
      return sentence({"acceleration constraint ", base::counted(i + 1).view(),
                       " does not follow from the constraints on the velocities"});
  consistent_states states(s, configuration, configuration.rows, c, c.size(), c.on_accelerations, true);
  const int i = first_that_never_vanishes(states, c.on_accelerations);
  if (i == none) return {};
  return sentence({"acceleration constraint ", base::counted(i + 1).view(),
                   " is not the time derivative of the constraints on the velocities: the terms without "
                   "rates of speeds differ"});
}

} // namespace kanexpr::mechanics
