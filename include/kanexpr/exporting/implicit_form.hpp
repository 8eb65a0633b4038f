#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/equations.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>

namespace kanexpr::exporting {

/// The residual of the equations of motion at given rates: q̇ − q̇(q, u), the residual M u̇ − f of inverse
/// dynamics in the rows of the independent speeds, and the rates of the constraints in the rows of the
/// dependent speeds. It contains no multipliers, and no system is solved for u̇.
inline symbolic::matrix implicit_form(symbolic::graph& g, mechanics::equations& of) {
  const mechanics::general_form& form = of.linearized().freely().form();
  const base::sequence<symbolic::expression> force = mechanics::summed(form.f_2, form.f_3);
  const int coordinates = form.q.size();
  symbolic::matrix residual(g, coordinates + form.u.size(), 1);
  for (int i = 0; i < coordinates; ++i) residual(i, 0) = form.qdot[i] - form.known.qdot[i];
  for (int i = 0; i < force.size(); ++i) residual(coordinates + form.speeds.independent[i], 0) = force[i];
  for (int i = 0; i < form.f_a.size(); ++i) residual(coordinates + form.speeds.dependent[i], 0) = form.f_a[i];
  return residual;
}

} // namespace kanexpr::exporting
