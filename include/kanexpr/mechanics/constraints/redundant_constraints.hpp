#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/constraints/consistent_configurations.hpp>
#include <kanexpr/mechanics/constraints/consistent_states.hpp>
#include <kanexpr/mechanics/constraints/constraints.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/wording.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

/// Configuration constraints that follow from the others: those that the model declares redundant, and those
/// that it should declare redundant.
namespace kanexpr::mechanics {

/// The constraints used in solving.
constexpr given_constraints without_redundant(const given_constraints& all) {
  if (all.redundant.empty()) return all;
  given_constraints solved = all;
  solved.on_configuration.clear(), solved.rates_by_auxiliary.clear();
  for (int i = 0; i < all.on_configuration.size(); ++i) {
    if (all.redundant.contains(i + 1)) continue;
    solved.on_configuration.push(all.on_configuration[i]);
    if (!all.rates_by_auxiliary.empty()) solved.rates_by_auxiliary.push(all.rates_by_auxiliary[i]);
  }
  return solved;
}

/// Records the numbers of the constraints used in solving, and the redundant ones.
constexpr void record_redundant(const given_constraints& all, constraints& c) {
  for (int i = 0; i < all.on_configuration.size(); ++i)
    if (all.redundant.contains(i + 1))
      c.redundant.push(all.on_configuration[i]), c.redundant_numbers.push(i + 1);
    else
      c.numbers.push(i + 1);
}

/// The redundant constraints, as constraints on the speeds.
constexpr constraints only_redundant(motion& k, const constraints& c) {
  return form_constraints(k, {.on_configuration = c.redundant});
}

/// Checks the numbers of the constraints declared redundant.
constexpr sentence check_redundant(const given_constraints& all) {
  for (int i = 0; i < all.redundant.size(); ++i) {
    const name number = base::counted(all.redundant[i]);
    if (all.redundant[i] < 1 || all.redundant[i] > all.on_configuration.size())
      return sentence({"redundant<", number.view(), "> is out of range: the model has ",
                       several(all.on_configuration.size(), "configuration constraint").view()});
    if (all.redundant.find(all.redundant[i]) != i)
      return sentence({"configuration constraint ", number.view(), " is listed twice in redundant<...>"});
  }
  return {};
}

/// The rate of a redundant constraint vanishes wherever the other constraints hold, for all speeds that they
/// admit, even though elsewhere its gradient need not be a linear combination of theirs. If the rate of a
/// constraint does not vanish at any of many such states, the constraint restricts a remaining motion and is
/// reported.
constexpr sentence check_redundant_rates(const skeleton& s, const constraints& c,
                                         const symbolic::matrix& configuration,
                                         const sequence<expression>& rates) {
  // values that are set at run time, such as equal lengths of bars, may make constraints redundant
  const contents held(*s.model->g);
  const sequence<expression> residual = c.velocity_residual();
  for (const sequence<expression>* all : {&rates, &c.on_configuration, &residual})
    for (const expression& e : *all)
      if (held.holds_any(e, {contents::kind::parameter, contents::kind::input})) return {};
  consistent_states states(s, configuration, configuration.rows, c, c.size(), rates);
  const int i = first_that_never_vanishes(states, rates, {.attempts = 30, .states = 8, .least = 3});
  if (i == none) return {};
  const name number = base::counted(c.redundant_numbers[i]);
  return sentence({"configuration constraint ", number.view(),
                   " does not follow from the others, so it is not redundant; remove redundant<",
                   number.view(), ">"});
}

/// Returns advice if the constraints seem to leave no motion, but some of them follow from the others where
/// all hold, as in the closure equations of a loop with special geometry: "; where all hold, configuration
/// constraint 5 follows from the preceding ones; add redundant<5> to drop it". The advice is empty if the
/// constraints really leave no motion.
constexpr sentence advice_on_redundant(const mechanism& m, const symbolic::matrix& by_q,
                                       const constraints& c) {
  constexpr double nothing = 1e-6;
  const int count = c.on_configuration.size();
  if (count < 2) return {};
  consistent_configurations states(m, by_q, c.on_configuration);
  sequence<char> adds(count, 0); // independent of the norms and of the preceding constraints at some state
  int found = 0;
  for (int attempts = 0; attempts < 12 && found < 2; ++attempts) {
    if (!states.next()) continue;
    ++found;
    row_space space(nothing);
    for (int i = 0; i < states.count_of_norms(); ++i) space.add(states.row(i));
    for (int i = 0; i < count; ++i)
      if (states.length_of_constraint(i) > nothing && space.add(states.row(states.count_of_norms() + i)))
        adds[i] = 1;
  }
  if (found == 0)
    return sentence({"; list configuration constraints that follow from others in redundant<...>"});
  sequence<int> numbers;
  for (int i = 0; i < count; ++i)
    if (adds[i] == 0) numbers.push(c.numbers[i]);
  if (numbers.empty() || count - numbers.size() >= m.coordinates.size()) return {};
  return sentence(
      {"; where all hold, ",
       dropping(numbers, " follows from the preceding ones", " follow from the preceding ones").view()});
}

} // namespace kanexpr::mechanics
