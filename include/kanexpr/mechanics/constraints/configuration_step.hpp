#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/constraints/dependent_speeds.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/motion/unit_quaternions.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::mechanics {

namespace detail {

/// Converts the derivatives with respect to all coordinates, evaluated at quaternions of norm 1, into those
/// of functions that normalize the quaternions first.
constexpr void preserve_norms(const mechanism& m, symbolic::matrix& by_all) {
  for (const sequence<int>& places : unit_quaternions(m))
    for (int i = 0; i < by_all.rows; ++i) {
      expression along = m.zero();
      for (int place : places) along += by_all(i, place) * m.coordinates[place];
      for (int place : places) by_all(i, place) -= along * m.coordinates[place];
    }
}

/// Whether a constraint is solved for a coordinate of a frame's quaternion.
constexpr bool binds_quaternion(const mechanism& m, const partition& coordinates) {
  for (const frame& f : m.frames)
    for (const expression& entry : f.quaternion)
      for (int dependent : coordinates.dependent)
        if (entry == m.coordinates[dependent]) return true;
  return false;
}

} // namespace detail

/// The Newton step of the dependent coordinates: the increment after which the linearized configuration
/// constraints hold. Quaternions have norm 1, which the step preserves.
constexpr symbolic::linear_solution configuration_step(const mechanism& m,
                                                       const sequence<expression>& constraints,
                                                       symbolic::matrix by_all,
                                                       const partition& coordinates) {
  if (detail::binds_quaternion(m, coordinates)) detail::preserve_norms(m, by_all);
  symbolic::matrix right(*m.g, by_all.rows, 1);
  for (int i = 0; i < right.rows; ++i) right(i, 0) = -constraints[i];
  return symbolic::solve_linear(*m.g, detail::columns_of(*m.g, by_all, coordinates.dependent), right, by_all,
                                symbolic::nodes_of(constraints));
}

} // namespace kanexpr::mechanics
