#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/constraints/dependent_speeds.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>

/// Kane's equations for the independent speeds.
///
/// With u̇_d = A u̇_i + b̄ and T = [E; A], the equations for all speeds, M u̇ = f, become Tᵀ M T u̇_i = f_i +
/// Aᵀ f_d − Bᵀ b̄. B = M_di + M_dd A appears on both sides.
namespace kanexpr::mechanics {

/// F_i + Aᵀ F_d: nonholonomic generalized forces. Kane & Levinson (1985), eq. 4.4.5.
constexpr sequence<expression> reduced(const sequence<expression>& force, const partition& speeds,
                                       const symbolic::matrix& on_independent) {
  sequence<expression> out;
  for (int i = 0; i < speeds.independent.size(); ++i) {
    expression sum = force[speeds.independent[i]];
    for (int d = 0; d < speeds.dependent.size(); ++d)
      sum += on_independent(d, i) * force[speeds.dependent[d]];
    out.push(sum);
  }
  return out;
}

/// B = M_di + M_dd A.
constexpr symbolic::matrix coupling(graph& g, const symbolic::matrix& mass, const partition& speeds,
                                    const symbolic::matrix& on_independent) {
  symbolic::matrix b(g, speeds.dependent.size(), speeds.independent.size());
  for (int d = 0; d < b.rows; ++d)
    for (int i = 0; i < b.columns; ++i) {
      b(d, i) = mass(speeds.dependent[d], speeds.independent[i]);
      for (int e = 0; e < b.rows; ++e)
        b(d, i) += mass(speeds.dependent[d], speeds.dependent[e]) * on_independent(e, i);
    }
  return b;
}

/// Tᵀ M T = M_ii + M_id A + Aᵀ B; symmetric.
constexpr symbolic::matrix reduced_mass(graph& g, const symbolic::matrix& mass, const partition& speeds,
                                        const symbolic::matrix& on_independent,
                                        const symbolic::matrix& coupling) {
  const sequence<int>&free = speeds.independent, &bound = speeds.dependent;
  symbolic::matrix out(g, free.size(), free.size());
  for (int i = 0; i < free.size(); ++i)
    for (int j = 0; j <= i; ++j) {
      expression sum = mass(free[i], free[j]);
      for (int d = 0; d < bound.size(); ++d)
        sum += sum_of_products(mass(free[i], bound[d]), on_independent(d, j), on_independent(d, i),
                               coupling(d, j));
      out(i, j) = out(j, i) = sum;
    }
  return out;
}

/// The reduced force minus the contribution Bᵀ b̄ of the bias of the dependent rates.
constexpr sequence<expression> reduced_force(const sequence<expression>& force, const partition& speeds,
                                             const dependent_speeds& solved,
                                             const symbolic::matrix& coupling) {
  sequence<expression> out = reduced(force, speeds, solved.on_independent);
  for (int i = 0; i < out.size(); ++i)
    for (int d = 0; d < coupling.rows; ++d) out[i] -= coupling(d, i) * solved.acceleration_bias[d];
  return out;
}

/// The matrix on the left-hand side of linear equations for the rates of all coordinates and speeds, q̇
/// followed by u̇. The rows are those of q̇, of the equations of motion, and of the constraints on the rates
/// of the dependent speeds.
constexpr symbolic::matrix mass_matrix_of_all(const mechanism& m, const partition& speeds,
                                              const symbolic::matrix& mass, const dependent_speeds& bound) {
  const int n = m.coordinates.size(), p = m.speeds.size();
  symbolic::matrix full(*m.g, n + p, n + p);
  for (int i = 0; i < n; ++i) full(i, i) = m.one();
  int row = n;
  for (int i = 0; i < mass.rows; ++i, ++row)
    for (int j = 0; j < mass.columns; ++j) full(row, n + speeds.independent[j]) = mass(i, j);
  for (int d = 0; d < speeds.dependent.size(); ++d, ++row) {
    full(row, n + speeds.dependent[d]) = m.one();
    for (int j = 0; j < speeds.independent.size(); ++j)
      full(row, n + speeds.independent[j]) = -bound.on_independent(d, j);
  }
  return full;
}

/// The right-hand side of the rows of u̇ in these equations.
constexpr sequence<expression> forcing_of_all(sequence<expression> force, const dependent_speeds& bound) {
  for (const expression& b : bound.acceleration_bias) force.push(b);
  return force;
}

} // namespace kanexpr::mechanics
