#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/wording.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>

namespace kanexpr::mechanics {

namespace detail {

/// Whether the coefficient of a speed or rate contains no speeds or rates; this test is exact, unlike the
/// quick test of `contents`.
constexpr bool is_linear(expression e, expression symbol) {
  using kind = contents::kind;
  const expression slope = symbolic::differentiate(e, symbol);
  return !contents(e.owner()).holds_any(slope, {kind::speed, kind::auxiliary_speed, kind::coordinate_rate});
}

} // namespace detail

/// Returns "<of> is not linear in speed u1", or an empty sentence.
constexpr sentence check_linear(const mechanism& m, const contents& held, expression e, std::string_view of) {
  if (held.looks_linear(e)) return {};
  struct list {
    const sequence<expression>& symbols;
    std::string_view are;
  };
  for (const list& each : {list{m.coordinate_rates, "the rate of coordinate "}, list{m.speeds, "speed "},
                           list{m.auxiliary_speeds, "auxiliary speed "}})
    for (const expression& s : each.symbols) {
      if (detail::is_linear(e, s)) continue;
      if (m.derived_by == method::lagrange)
        return sentence({of, " is not linear in the ", speed_called(m, called(m, s)).view()});
      return sentence({of, " is not linear in ", each.are, called(m, s)});
    }
  return {};
}

} // namespace kanexpr::mechanics
