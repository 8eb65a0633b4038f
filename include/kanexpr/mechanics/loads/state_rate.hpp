#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/loads/force_system.hpp>
#include <kanexpr/mechanics/loads/load_check.hpp>
#include <kanexpr/mechanics/loads/load_units.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/wording.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/substitute.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <string_view>

namespace kanexpr::mechanics {

/// The rate ż = f of a state variable, as the generalized force f of a speed with the mass 1. This
/// corresponds to the term ½ ż² in the energy of acceleration S of the Gibbs–Appell equations, ∂S/∂u̇_r = F_r.
///
/// The rate is not given if it belongs to a load that depends on motion, such as a tyre, which adds f itself
/// and has the function `add_state_rates`.
struct state_rate {
  int speed = none;      ///< the place of the state variable among the speeds
  expression rate{};     ///< f
  expression equation{}; ///< the difference of the sides of the equation from which f was found

  constexpr bool is_of_load() const { return !rate.is_given(); }

  constexpr void act(force_system& on, conservative) const {
    if (!is_of_load()) on.add_share(speed, on.known(rate));
  }

  constexpr void check_with(load_check& by, int) const {
    if (is_of_load()) return;
    const mechanism& m = by.mechanism_used();
    by.check_no_speed_rates(rate, "the rate of state variable ", called(m, m.speeds[speed]));
  }

  constexpr void state_units(load_units& by, int) const {
    if (is_of_load()) return;
    const mechanism& m = by.mechanism_used();
    by.describe({"the dynamics of state variable ", called(m, m.speeds[speed])});
    by.expect_equation(equation);
  }
};

/// The rate of a state variable from an equation, or a mistake.
struct solved_state_rate {
  sentence mistake{};
  state_rate found{};
};

/// Solves an equation, given by the difference of its sides, for the rate of a state variable in which it is
/// linear.
constexpr solved_state_rate solve_for_state_rate(const mechanism& m, int speed, expression equation) {
  const expression symbol = m.speed_rates[speed], slope = symbolic::differentiate(equation, symbol);
  symbolic::substitution at_rest(*m.g);
  at_rest.replace(symbol, m.zero());
  const auto fail = [&](std::string_view how) {
    return solved_state_rate{sentence({"the dynamics of state variable ", called(m, m.speeds[speed]), how}),
                             {}};
  };
  if (slope.is_zero()) return fail(" do not determine its rate");
  if (contents(*m.g).symbols_in(slope, {symbolic::symbol_kind::speed_rate}).contains(symbol.node()))
    return fail(" are not linear in its rate");
  const expression remainder = at_rest.in(equation);
  return {{}, {speed, -remainder / slope, equation}};
}

/// The rates of state variables without the rates of others: one may be given in terms of another.
constexpr sequence<expression> resolved_state_rates(const mechanism& m, const sequence<state_rate>& given) {
  sequence<expression> rates;
  for (const state_rate& each : given) rates.push(each.rate);
  const contents held(*m.g);
  bool is_any = false;
  for (const expression& rate : rates) is_any = is_any || held.holds(rate, symbolic::symbol_kind::speed_rate);
  for (int pass = 1; is_any && pass < given.size(); ++pass) {
    symbolic::substitution known(*m.g);
    for (const state_rate& each : given) known.replace(m.speed_rates[each.speed], each.rate);
    for (expression& rate : rates) rate = known.in(rate);
  }
  return rates;
}

/// Reports a state variable without a rate or with two, and rates that depend on each other; empty if there
/// is none. The rates of loads do not contain other rates.
constexpr sentence check_state_rates(const mechanism& m, sequence<state_rate> given) {
  for (int i = m.speeds_of_motion(); i < m.speeds.size(); ++i) {
    int rates = 0;
    for (const state_rate& each : given) rates += each.speed == i ? 1 : 0;
    if (rates == 1) continue;
    return sentence({"state variable ", called(m, m.speeds[i]),
                     rates == 0 ? " has no dynamics" : " has two dynamics",
                     "; write one equation, dynamics<dot(", called(m, m.speeds[i]), ") == rate>"});
  }
  for (state_rate& each : given)
    if (each.is_of_load()) each.rate = m.zero();
  const sequence<expression> rates = resolved_state_rates(m, given);
  const contents held(*m.g);
  for (int i = 0; i < rates.size(); ++i)
    if (held.holds(rates[i], symbolic::symbol_kind::speed_rate))
      return sentence({"the rate of state variable ", called(m, m.speeds[given[i].speed]),
                       " depends on rates that depend on each other"});
  return {};
}

} // namespace kanexpr::mechanics
