#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/constraints/dependent_speeds.hpp>
#include <kanexpr/mechanics/constraints/partition.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>

/// Linear equations for the rates of all coordinates and speeds: q̇, the equations of motion, and the
/// constraints on the rates of the dependent speeds.
namespace kanexpr::mechanics {

/// The matrix on the left-hand side, for q̇ followed by u̇.
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

/// The right-hand side of the rows of u̇.
constexpr sequence<expression> forcing_of_all(sequence<expression> force, const dependent_speeds& bound) {
  for (const expression& b : bound.acceleration_bias) force.push(b);
  return force;
}

} // namespace kanexpr::mechanics
