#pragma once

#include <kanexpr/mechanics/loads/given_potential_energy.hpp>
#include <kanexpr/mechanics/loads/loads.hpp>
#include <kanexpr/mechanics/model/flexible_body.hpp>
#include <kanexpr/mechanics/model/flexible_expressions.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>

namespace kanexpr::mechanics {

/// Adds a flexible body to a mechanism, with its elastic energy and its damping.
constexpr void add_flexible_body(mechanism& m, loads& acting, const flexible_body& b,
                                 const flexible_expressions& of) {
  m.flexible_bodies.push(b);
  acting.potential_energies.push(elastic_energy(b.amplitudes, of.stiffness()));
  const expression further = of.further_energy();
  if (!further.is_zero()) acting.potential_energies.push({further, true});
  const symbolic::matrix damping = of.damping();
  bool is_damped = false;
  for (const expression& e : damping.entries) is_damped = is_damped || !e.is_zero();
  if (is_damped) acting.modal_dampings.push({b.amplitudes, damping});
}

} // namespace kanexpr::mechanics
