#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/loads/loads.hpp>
#include <kanexpr/mechanics/loads/muscle.hpp>
#include <kanexpr/mechanics/loads/state_rate.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/wording.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

namespace kanexpr::mechanics {

/// Reports a state variable without a rate or with two, and rates that depend on each other; empty if there
/// is none.
constexpr sentence check_state_rates(const mechanism& m, const loads& all) {
  const sequence<state_rate>& given = all.state_rates;
  for (int i = m.speeds_of_motion(); i < m.speeds.size(); ++i) {
    int rates = 0;
    for (const state_rate& each : given) rates += each.speed == i ? 1 : 0;
    for (const muscle& each : all.muscles) rates += each.tendon_state == m.speeds[i] ? 1 : 0;
    if (rates == 1) continue;
    return sentence({"state variable ", called(m, m.speeds[i]),
                     rates == 0 ? " has no dynamics" : " has two dynamics",
                     "; write one equation, dynamics<dot(", called(m, m.speeds[i]), ") == rate>"});
  }
  const sequence<expression> rates = resolved_state_rates(m, given);
  const contents held(*m.g);
  for (int i = 0; i < rates.size(); ++i)
    if (held.holds(rates[i], symbolic::symbol_kind::speed_rate))
      return sentence({"the rate of state variable ", called(m, m.speeds[given[i].speed]),
                       " depends on rates that depend on each other"});
  return {};
}

} // namespace kanexpr::mechanics
