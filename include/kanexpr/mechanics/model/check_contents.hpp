#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/wording.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <string_view>

/// Checks the symbols that an expression contains. `of` and `whose` name the expression in error messages,
/// such as "the angle of frame " and "B".
namespace kanexpr::mechanics {

/// Returns, for example, "speed u1", "rate of coordinate q1" or "time t".
constexpr sentence symbol_called(const mechanism& m, contents::kind kind, std::string_view called) {
  switch (kind) {
  case contents::kind::speed: return speed_called(m, called);
  case contents::kind::speed_rate: return speed_rate_called(m, called);
  case contents::kind::auxiliary_speed: return sentence({"auxiliary speed ", called});
  case contents::kind::coordinate_rate: return sentence({"rate of coordinate ", called});
  case contents::kind::input: return sentence({"input ", called});
  case contents::kind::time: return sentence({"time ", called});
  default: return sentence({"coordinate ", called});
  }
}

/// Returns the name of a symbol of one of the given kinds that the expression contains, such as "speed u1";
/// an empty message if there is none.
constexpr sentence symbol_in(const mechanism& m, const contents& held, expression e,
                             std::initializer_list<contents::kind> kinds) {
  for (const contents::kind kind : kinds)
    if (held.holds(e, kind)) return symbol_called(m, kind, held.name_of(e, kind));
  return {};
}

/// Reports a state variable, or the rate of one, in an expression that describes the motion. State variables
/// move nothing, so they may appear only in loads, in the rates of state variables and in results.
constexpr sentence check_no_state_variable(const mechanism& m, const contents& held, expression e,
                                           std::string_view of, std::string_view whose = {}) {
  using kind = symbolic::symbol_kind;
  if (m.state_variables == 0) return {};
  for (const int id : held.symbols_in(e, {kind::speed, kind::speed_rate})) {
    const symbolic::symbol& s = m.g->symbol_at(id);
    if (s.position < m.speeds_of_motion()) continue;
    return sentence({of, whose, " contains the ", symbol_called(m, s.kind, s.called.view()).view(),
                     "; state variables may appear only in loads, dynamics and results"});
  }
  return {};
}

/// Reports speeds or rates in a quantity that must be a function of coordinates, parameters, inputs and time.
constexpr sentence check_no_rates(const mechanism& m, const contents& held, expression e, std::string_view of,
                                  std::string_view whose) {
  using kind = symbolic::symbol_kind;
  const sentence found =
      symbol_in(m, held, e, {kind::speed, kind::auxiliary_speed, kind::coordinate_rate, kind::speed_rate});
  if (!found) return {};
  return sentence({of, whose, " contains the ", found.view(), "; it may contain only coordinates"});
}

/// Reports an input whose derivatives up to the given order are not known, in a quantity that is
/// differentiated.
constexpr sentence check_prescribed(const mechanism& m, const contents& held, expression e, int derivatives,
                                    std::string_view of, std::string_view whose = {}) {
  sequence<int> inputs;
  held.collect(e, symbolic::symbol_kind::input, inputs);
  for (const int input : inputs) {
    int at = input;
    for (int order = 1; order <= derivatives; ++order) {
      int rate = none;
      for (const prescribed_rate& p : m.prescribed_rates)
        if (p.quantity.node() == at) rate = p.rate.node();
      if (rate == none)
        return sentence({of, whose, " contains the input ", m.g->symbol_at(input).called.view(), ", whose ",
                         order == 1 ? "rate" : "second derivative",
                         " is not known; declare it prescribed and list its rates among the inputs"});
      at = rate;
    }
  }
  return {};
}

/// Reports an expression that is not linear in a speed or rate. The coefficient of each is formed and checked
/// only if the expression does not look linear.
constexpr sentence check_linear(const mechanism& m, const contents& held, expression e, std::string_view of,
                                std::string_view whose = {}) {
  using kind = symbolic::symbol_kind;
  if (held.looks_linear(e)) return {};
  for (const sequence<expression>* all : {&m.coordinate_rates, &m.speeds, &m.auxiliary_speeds})
    for (const expression& s : *all) {
      const expression slope = symbolic::differentiate(e, s);
      if (!contents(*m.g).holds_any(slope, {kind::speed, kind::auxiliary_speed, kind::coordinate_rate}))
        continue;
      return sentence({of, whose, " is not linear in the ",
                       symbol_called(m, m.g->symbol_at(s.node()).kind, called(m, s)).view()});
    }
  return {};
}

} // namespace kanexpr::mechanics
