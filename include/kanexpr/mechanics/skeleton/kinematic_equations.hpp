#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/derivatives/jacobian.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/substitute.hpp>
#include <kanexpr/symbolic/linear/solve.hpp>

namespace kanexpr::mechanics {

/// The kinematic differential equations K(q,t) q̇ + k(q,u,t) = 0.
struct linear_kinematics {
  symbolic::matrix k_rates;       ///< K
  sequence<expression> remainder; ///< k
};

constexpr linear_kinematics linear_in_rates(const mechanism& m) {
  linear_kinematics out{symbolic::forward_jacobian(*m.g, m.kinematics, m.coordinate_rates), {}};
  symbolic::substitution at_rest(*m.g);
  for (const expression& rate : m.coordinate_rates) at_rest.replace(rate, m.zero());
  for (const expression& e : m.kinematics) out.remainder.push(at_rest.in(e));
  return out;
}

/// q̇ as expressions of q, u and t, and the coupled equations that were solved for them.
struct solved_rates {
  sequence<expression> rates;
  sequence<symbolic::solved_block> blocks;
};

/// Returns q̇ as expressions of q, u and t. The rates of a part that cannot be solved are zero; `check` has
/// already reported the mistake.
constexpr solved_rates solve_kinematics(const mechanism& m) {
  const linear_kinematics k = linear_in_rates(m);
  symbolic::matrix right(*m.g, k.k_rates.rows, 1);
  for (int i = 0; i < k.k_rates.rows; ++i) right(i, 0) = -k.remainder[i];
  const symbolic::linear_solution solved =
      symbolic::solve_linear(*m.g, k.k_rates, right, k.k_rates, symbolic::nodes_of(m.kinematics));
  return {solved.x.entries, solved.blocks};
}

} // namespace kanexpr::mechanics
