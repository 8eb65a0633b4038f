#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/dynamics/minimal.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>

/// Forces that do no work, from Kane's equations for the dependent and the auxiliary speeds.
namespace kanexpr::mechanics {

/// F_r + F_r* = f − M u̇ in the actual motion, for the given speeds; zero for all others.
constexpr sequence<expression> residual_forces(const symbolic::matrix& mass,
                                               const sequence<expression>& force,
                                               const sequence<expression>& udot, const sequence<int>& ways) {
  sequence<expression> out;
  for (int r : ways) {
    expression left = force[r];
    for (int j = 0; j < udot.size(); ++j) left -= mass(r, j) * udot[j];
    out.push(left);
  }
  return out;
}

/// Lagrange multipliers: λ_j is the force on the system along the direction in which constraint j sets a
/// velocity to zero. They follow from the equations for the dependent speeds, J_dᵀ λ = −(F_d + F_d*).
constexpr symbolic::linear_solution multipliers(graph& g, const constraints& c, const partition& speeds,
                                                const sequence<expression>& residual_of_dependent) {
  symbolic::matrix right(g, c.size(), 1);
  for (int i = 0; i < right.rows; ++i) right(i, 0) = -residual_of_dependent[i];
  return symbolic::solve_linear(g, transposed(g, detail::columns_of(g, c.jacobian, speeds.dependent)), right);
}

/// The forces along the partial velocities of each auxiliary speed that keep the speed at zero: −(F_a + F_a*
/// + J_aᵀ λ).
constexpr sequence<expression> noncontributing_forces(const constraints& c, const symbolic::matrix& lambda,
                                                      const sequence<expression>& residual_of_auxiliary) {
  sequence<expression> out;
  for (int a = 0; a < residual_of_auxiliary.size(); ++a) {
    expression force = residual_of_auxiliary[a];
    for (int i = 0; i < c.size(); ++i) force += c.by_auxiliary(i, a) * lambda(i, 0);
    out.push(-force);
  }
  return out;
}

} // namespace kanexpr::mechanics
