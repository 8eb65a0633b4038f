#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/constraints/partition.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/wording.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/functions.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/live_nodes.hpp>
#include <kanexpr/symbolic/linear/solve.hpp>
#include <kanexpr/symbolic/sizes/finiteness.hpp>

#include <string_view>

/// Checks for linear systems that may be singular at some states, and for results that may not be finite.
namespace kanexpr::mechanics {

/// One linear system: its measure, which vanishes relative to its scale if the system is singular, and the
/// cause to report.
struct singularity_check {
  int key = 0; ///< all results that need the solution depend on this node
  expression measure{}, scale{};
  sentence cause{};
  bool of_finiteness = false; ///< checks only that the measure is finite
};

/// The checks of coupled equations that are solved for unknowns. `system` describes the equations, and
/// `called(columns)` names the unknowns of a block.
template <class Called>
constexpr sequence<singularity_check> checks_of_blocks(const sequence<symbolic::solved_block>& blocks,
                                                       std::string_view system, const Called& called) {
  sequence<singularity_check> checks;
  for (const symbolic::solved_block& b : blocks)
    checks.push({b.key, b.measure, b.scale,
                 sentence({system, " cannot be solved for ", called(b.columns).view(), " at this state"})});
  return checks;
}

constexpr sequence<singularity_check> checks_of_rates(const mechanism& m,
                                                      const sequence<symbolic::solved_block>& blocks) {
  return checks_of_blocks(blocks, "the kinematic differential equations", [&](const sequence<int>& columns) {
    return sentence({"the rate of ", enumerated(m, m.coordinates, columns, "coordinate").view()});
  });
}

constexpr sequence<singularity_check> checks_of_inputs(const mechanism& m,
                                                       const sequence<symbolic::solved_block>& blocks) {
  return checks_of_blocks(blocks, "the equations of motion", [&](const sequence<int>& columns) {
    return enumerated(m, m.inputs, columns, "input");
  });
}

constexpr sequence<singularity_check> checks_of_coordinates(const mechanism& m, const partition& coordinates,
                                                            const sequence<symbolic::solved_block>& blocks) {
  return checks_of_blocks(blocks, "the constraints", [&](const sequence<int>& columns) {
    const sequence<int> places = coordinates.dependent_in(columns);
    return sentence({"the dependent ", enumerated(m, m.coordinates, places, "coordinate").view()});
  });
}

constexpr sequence<singularity_check> checks_of_speeds(const mechanism& m, const partition& speeds,
                                                       const sequence<symbolic::solved_block>& blocks) {
  return checks_of_blocks(blocks, "the constraints", [&](const sequence<int>& columns) {
    return sentence({"the dependent ", speeds_called(m, speeds.dependent_in(columns)).view()});
  });
}

/// Checks for the pivots of a mass matrix, one for each pivot. The kinetic energy of flexible bodies is
/// truncated after the second order in the amplitudes; it becomes negative for some motion if they are large.
/// For a system with such bodies, a pivot must therefore be positive: its measure, x + |x|, vanishes if it is
/// negative.
constexpr sequence<singularity_check> checks_of_mass(const mechanism& m, const partition& speeds,
                                                     const sequence<symbolic::pivot>& pivots) {
  sequence<singularity_check> checks;
  for (const symbolic::pivot& p : pivots) {
    bool is_new = true;
    for (const singularity_check& g : checks) is_new = is_new && g.key != p.key;
    if (!is_new) continue;
    const sentence which = speeds_called(m, {speeds.independent[p.place]});
    if (m.flexible_bodies.empty())
      checks.push({p.key, p.value, p.entry,
                   sentence({"the mass matrix is singular at this state: its elimination fails at the ",
                             which.view()})});
    else
      checks.push({p.key, p.value + abs(p.value), p.entry,
                   sentence({"the mass matrix is not positive definite at this state: its elimination fails "
                             "at the ",
                             which.view(), "; a flexible body may be deformed too much"})});
  }
  return checks;
}

inline constexpr std::string_view results_not_finite =
    "the results are not finite at this state; check for unset values";

/// The check for results that may be infinite or NaN at a state; empty if none can be. `live` are the live
/// nodes of the outputs, and `others` the preceding checks.
constexpr sequence<singularity_check> checks_of_finiteness(const mechanism& m, const sequence<int>& outputs,
                                                           const symbolic::live_list& live,
                                                           const sequence<int>& sure_divisors,
                                                           const sequence<singularity_check>& others) {
  graph& g = *m.g;
  const symbolic::finiteness found(g, outputs, live, sure_divisors);
  const sequence<int> watched = found.outputs_to_check();
  if (watched.empty()) return {};
  sequence<int> known, places;
  for (const singularity_check& each : others) known.push(each.key);
  sequence<expression> suspects;
  for (int symbol : found.suspicious_symbols(known)) places.push(suspects.push({g, symbol}));
  constexpr int most_names = 6; // longer lists do not help
  const bool are_named = !places.empty() && places.size() <= most_names;
  const expression sum{g, symbolic::unsimplified_sum(g, watched)};
  return {{sum.node(), sum, sum,
           sentence({results_not_finite,
                     found.has_infinite_number()
                         ? ", and for numbers of the system that are too small or too large"
                         : "",
                     are_named ? ", and check the quotients and functions of " : "",
                     are_named ? enumerated(m, suspects, places).view() : ""}),
           true}};
}

/// The checks on which the outputs depend; the last one checks that the outputs are finite.
constexpr sequence<singularity_check> needed_checks(const mechanism& m,
                                                    const sequence<singularity_check>& all,
                                                    const sequence<int>& sure_divisors,
                                                    const sequence<int>& outputs) {
  const symbolic::live_list live(*m.g, outputs);
  sequence<singularity_check> needed;
  for (const singularity_check& each : all)
    if (symbolic::depends_on_block(*m.g, live.marks, each.key)) needed.push(each);
  needed.append(checks_of_finiteness(m, outputs, live, sure_divisors, needed));
  return needed;
}

} // namespace kanexpr::mechanics
