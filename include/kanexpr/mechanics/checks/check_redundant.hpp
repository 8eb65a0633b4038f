#pragma once

#include <kanexpr/mechanics/constraints/consistent_states.hpp>
#include <kanexpr/mechanics/model/wording.hpp>
#include <kanexpr/symbolic/graph/live_nodes.hpp>

/// Checks that the constraints declared redundant follow from the others.
namespace kanexpr::mechanics {

namespace detail {

/// Whether constraints contain symbols whose values are set at run time. They may then be redundant only for
/// particular values, such as equal lengths of bars.
constexpr bool depend_on_values(const graph& g, const sequence<expression>& all) {
  using kind = symbolic::symbol_kind;
  for (int id : symbolic::live_values(g, symbolic::nodes_of(all)))
    if (g[id].op == symbolic::operation::symbol)
      if (const kind k = g.symbol_at(id).kind; k == kind::parameter || k == kind::input) return true;
  return false;
}

} // namespace detail

/// The rate of a redundant constraint vanishes wherever the other constraints hold, for all speeds that they
/// permit, even if its gradient is not a linear combination of theirs elsewhere. If the rate of a constraint
/// is nonzero at each of several such states, the constraint restricts a motion that the others permit, and
/// it is reported. `listed` contains the numbers of the redundant constraints in the order of the model.
constexpr sentence check_redundant_rates(const skeleton& s, const sequence<int>& listed, const constraints& c,
                                         const symbolic::matrix& configuration,
                                         const sequence<expression>& rates) {
  sequence<expression> said = rates;
  for (const expression& f : c.on_configuration) said.push(f);
  for (const velocity_constraint& v : c.on_velocities) said.push(v.value);
  if (detail::depend_on_values(*s.model->g, said)) return {};
  consistent_states states(s, configuration, configuration.rows, c, c.size(), rates);
  const int i = first_that_never_vanishes(states, rates, {.attempts = 30, .states = 8, .least = 3});
  if (i == none) return {};
  int number = 0; // redundant constraints come in the order of the model
  for (int left = i + 1; left > 0; --left)
    for (++number; !listed.contains(number);) ++number;
  return sentence({"configuration constraint ", counted(number).view(),
                   " does not follow from the others, so it is not redundant; remove redundant<",
                   counted(number).view(), ">"});
}

} // namespace kanexpr::mechanics
