#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/constraints/consistent_states.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/wording.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

/// Checks that the constraints declared redundant follow from the others.
namespace kanexpr::mechanics {

/// The rate of a redundant constraint vanishes wherever the other constraints hold, for all speeds that they
/// admit, even though elsewhere its gradient may be no linear combination of theirs. A constraint whose rate
/// vanishes at none of many such states restricts a remaining motion and is reported. `listed` contains the
/// numbers of the redundant constraints in the order of the model.
constexpr sentence check_redundant_rates(const skeleton& s, const sequence<int>& listed, const constraints& c,
                                         const symbolic::matrix& configuration,
                                         const sequence<expression>& rates) {
  // values that are set at run time may make constraints redundant, such as those of bars of equal length
  using kind = contents::kind;
  const contents held(*s.model->g);
  const sequence<expression> residual = c.velocity_residual();
  for (const sequence<expression>* all : {&rates, &c.on_configuration, &residual})
    for (const expression& e : *all)
      if (held.holds_any(e, {kind::parameter, kind::input})) return {};
  consistent_states states(s, configuration, configuration.rows, c, c.size(), rates);
  const int i = first_that_never_vanishes(states, rates, {.attempts = 30, .states = 8, .least = 3});
  if (i == none) return {};
  int number = 0; // redundant constraints come in the order of the model
  for (int left = i + 1; left > 0; --left)
    for (++number; !listed.contains(number);) ++number;
  return sentence({"configuration constraint ", base::counted(number).view(),
                   " does not follow from the others, so it is not redundant; remove redundant<",
                   base::counted(number).view(), ">"});
}

} // namespace kanexpr::mechanics
