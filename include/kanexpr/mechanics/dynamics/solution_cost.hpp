#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/formulation.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/symbolic/cost.hpp>
#include <kanexpr/symbolic/elimination_cost.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>
#include <kanexpr/symbolic/linear/linear_system.hpp>
#include <kanexpr/symbolic/linear/solve.hpp>

/// The choice between two solutions of the same equations by what their operations cost.
namespace kanexpr::mechanics {

using symbolic::operation_weights;

/// The cost of u̇ = M⁻¹ f by composite bodies and elimination of M, including M and f.
constexpr symbolic::cost cost_by_elimination(const symbolic::matrix& mass,
                                             const sequence<expression>& force) {
  sequence<expression> all = force;
  for (int i = 0; i < mass.rows; ++i)
    for (int j = 0; j <= i; ++j) all.push(mass(i, j));
  const symbolic::cost formed = symbolic::cost_of(all[0].owner(), symbolic::nodes_of(all));
  return added(formed, symbolic::elimination_cost(mass));
}

/// The cost of a solution, with the entries to which its pivots are compared.
constexpr symbolic::cost cost_of(const symbolic::symmetric_solution& solved) {
  sequence<expression> all = solved.x;
  for (const symbolic::pivot& p : solved.pivots) all.push(p.entry);
  return symbolic::cost_of(all[0].owner(), symbolic::nodes_of(all));
}

/// Whether a solution by articulated bodies may cost less, judged by a lower bound for each speed. Forming a
/// solution that is not used costs compile time.
constexpr bool may_pay_by_articulated_bodies(const skeleton& s, const symbolic::matrix& mass,
                                             const sequence<expression>& force, const operation_weights& by) {
  struct threshold {
    int speeds, operations;
  };
  constexpr threshold in_plane{7, 50}, in_space{10, 150}; // measured on chains and trees
  bool is_planar = true;
  for (int axes : s.working_axes) is_planar = is_planar && axes == mechanism::inertial;
  const threshold fewest = is_planar ? in_plane : in_space;
  if (mass.rows < fewest.speeds) return false;
  const symbolic::cost formed = symbolic::cost_of(*s.model->g, symbolic::nodes_of(force));
  const long long mean = (1LL * by.multiplication + by.addition + 1) / 2;
  return cost_by_elimination(mass, force).weighted(by) - formed.weighted(by) >
         mean * fewest.operations * mass.rows;
}

} // namespace kanexpr::mechanics
