#pragma once

#include <kanexpr/mechanics/constraints/consistent_states.hpp>
#include <kanexpr/mechanics/model/wording.hpp>
#include <kanexpr/symbolic/graph/live_nodes.hpp>

/// Whether what a model calls redundant follows from the other constraints.
namespace kanexpr::mechanics {

namespace detail {

/// Whether constraints hold symbols that a program gives values: then they may follow for some values only,
/// such as bars of one length.
constexpr bool depend_on_values(const graph& g, const sequence<expression>& all) {
  using kind = symbolic::symbol_kind;
  for (int id : symbolic::live_values(g, symbolic::nodes_of(all)))
    if (g[id].op == symbolic::operation::symbol)
      if (const kind k = g.symbol_at(id).kind; k == kind::parameter || k == kind::input) return true;
  return false;
}

} // namespace detail

/// Where the other constraints hold, with speeds that they allow, the rate of a constraint that follows from
/// them vanishes, though elsewhere its gradient may be no combination of theirs. One that vanishes at none of
/// many such states binds what the others leave free. `listed` are its numbers in the order of the model.
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
  int number = 0; // those that are not solved with come in the order of the model
  for (int left = i + 1; left > 0; --left)
    for (++number; !listed.contains(number);) ++number;
  return sentence({"configuration constraint ", counted(number).view(),
                   " does not follow from the others; redundant<", counted(number).view(),
                   "> would let it go"});
}

} // namespace kanexpr::mechanics
