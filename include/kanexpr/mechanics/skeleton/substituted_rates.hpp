#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/mechanics/skeleton/vector_substitution.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/live_nodes.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>
#include <kanexpr/symbolic/graph/substitute.hpp>
#include <kanexpr/symbolic/linear/linear_system.hpp>

namespace kanexpr::mechanics {

/// Replaces the symbols q̇ by the kinematic equations, and the auxiliary speeds by zero.
constexpr symbolic::matrix at_coordinate_rates(const skeleton& s, symbolic::matrix m) {
  known_rates known(*s.model, s.coordinate_rates);
  without_auxiliary_speeds drop(*s.model);
  for (expression& e : m.entries) e = drop.in(known.in(e));
  return m;
}

/// Whether a matrix contains symbols u̇.
constexpr bool has_speed_rates(const mechanism& model, const symbolic::matrix& m) {
  return depends_on(*model.g, nodes_of(m.entries), nodes_of(model.speed_rates));
}

/// Replaces the symbols u̇ by the given rates of all speeds.
constexpr symbolic::matrix at_speed_rates(const mechanism& model, symbolic::matrix m,
                                          const sequence<expression>& udot) {
  symbolic::substitution accelerated(*model.g);
  for (int i = 0; i < model.speeds.size(); ++i) accelerated.replace(model.speed_rates[i], udot[i]);
  for (expression& e : m.entries) e = accelerated.in(e);
  return m;
}

} // namespace kanexpr::mechanics
