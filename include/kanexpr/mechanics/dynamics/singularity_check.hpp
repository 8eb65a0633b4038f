#pragma once

#include <kanexpr/mechanics/constraints/partition.hpp>
#include <kanexpr/mechanics/model/wording.hpp>
#include <kanexpr/symbolic/graph/live_nodes.hpp>
#include <kanexpr/symbolic/linear/solve.hpp>
#include <kanexpr/symbolic/sizes/finiteness.hpp>

/// Where a system of linear equations on the way to a result may have no solution at some states, or a result
/// no finite value.
namespace kanexpr::mechanics {

/// One such system: its measure, which beside its scale vanishes where it is singular, and what to say there.
struct singularity_check {
  int key = 0; ///< the node that all results depend on which need the solution
  expression measure{}, scale{};
  sentence cause{};
  bool of_finiteness = false; ///< of the measure alone, which need not be beside anything
};

constexpr sequence<singularity_check> checks_of_rates(const mechanism& m,
                                                      const sequence<symbolic::solved_block>& blocks) {
  sequence<singularity_check> checks;
  for (const symbolic::solved_block& b : blocks)
    checks.push({b.key, b.measure, b.scale,
                 sentence({"the kinematic differential equations cannot be solved for the rate of ",
                           enumerated(m, m.coordinates, b.columns, "coordinate").view(), " at this state"})});
  return checks;
}

/// Of constraints that are solved for something dependent, which `called(places)` names.
template <class Called>
constexpr sequence<singularity_check> checks_of_constraints(const sequence<int>& dependent,
                                                            const sequence<symbolic::solved_block>& blocks,
                                                            Called called) {
  sequence<singularity_check> checks;
  for (const symbolic::solved_block& b : blocks) {
    sequence<int> places;
    for (int d : b.columns) places.push(dependent[d]);
    checks.push({b.key, b.measure, b.scale,
                 sentence({"the constraints cannot be solved for the dependent ", called(places).view(),
                           " at this state"})});
  }
  return checks;
}

constexpr sequence<singularity_check> checks_of_coordinates(const mechanism& m, const partition& coordinates,
                                                            const sequence<symbolic::solved_block>& blocks) {
  return checks_of_constraints(coordinates.dependent, blocks, [&](const sequence<int>& places) {
    return enumerated(m, m.coordinates, places, "coordinate");
  });
}

constexpr sequence<singularity_check> checks_of_speeds(const mechanism& m, const partition& speeds,
                                                       const sequence<symbolic::solved_block>& blocks) {
  return checks_of_constraints(speeds.dependent, blocks,
                               [&](const sequence<int>& places) { return speeds_called(m, places); });
}

constexpr sequence<singularity_check> checks_of_inputs(const mechanism& m,
                                                       const sequence<symbolic::solved_block>& blocks) {
  sequence<singularity_check> checks;
  for (const symbolic::solved_block& b : blocks)
    checks.push({b.key, b.measure, b.scale,
                 sentence({"the equations of motion cannot be solved for ",
                           enumerated(m, m.inputs, b.columns, "input").view(), " at this state"})});
  return checks;
}

/// Of the pivots of a mass matrix, each once.
constexpr sequence<singularity_check> checks_of_mass(const mechanism& m, const partition& speeds,
                                                     const sequence<symbolic::pivot>& pivots) {
  sequence<singularity_check> checks;
  for (const symbolic::pivot& p : pivots) {
    bool is_new = true;
    for (const singularity_check& g : checks) is_new = is_new && g.key != p.key;
    if (!is_new) continue;
    const sentence which = speeds_called(m, {speeds.independent[p.place]});
    checks.push({p.key, p.value, p.entry,
                 sentence({"the mass matrix is singular at this state: its elimination fails at the ",
                           which.view()})});
  }
  return checks;
}

/// Of all that leaves results infinite or no numbers at a state; none where nothing can. `others` are the
/// checks that come before it.
constexpr sequence<singularity_check> checks_of_finiteness(const mechanism& m, const sequence<int>& outputs,
                                                           const sequence<int>& sure_divisors,
                                                           const sequence<singularity_check>& others) {
  graph& g = *m.g;
  const symbolic::finiteness found(g, outputs, sure_divisors);
  const sequence<int> watched = found.watched();
  if (watched.empty()) return {};
  sequence<int> known, places;
  for (const singularity_check& each : others) known.push(each.key);
  sequence<expression> suspects;
  for (int symbol : found.suspects(known)) places.push(suspects.push({g, symbol}));
  constexpr int most_names = 6; // more tell nothing
  const bool are_named = !places.empty() && places.size() <= most_names;
  const expression sum{g, symbolic::plain_sum(g, watched)};
  sequence<singularity_check> checks;
  checks.push({sum.node(), sum, sum,
               sentence({"the results are not finite at this state; look for a value that was not set",
                         are_named ? ", and at the quotients and functions of " : "",
                         are_named ? enumerated(m, suspects, places).view() : ""}),
               true});
  return checks;
}

/// Those that some outputs depend on.
constexpr sequence<singularity_check> live_checks(const graph& g, const sequence<singularity_check>& all,
                                                  const sequence<int>& outputs) {
  sequence<singularity_check> live;
  if (all.empty()) return live;
  const sequence<char> needed = symbolic::live_nodes(g, outputs);
  for (const singularity_check& each : all)
    if (symbolic::rests_on(g, needed, each.key)) live.push(each);
  return live;
}

} // namespace kanexpr::mechanics
