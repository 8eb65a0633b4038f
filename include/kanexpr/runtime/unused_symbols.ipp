#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/multibody_system.hpp>
#include <kanexpr/runtime/each_expression.ipp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/live_nodes.hpp>

#include <string_view>

namespace kanexpr::runtime {

/// Reports a parameter, an input or an auxiliary speed that is used neither in the system nor in `elsewhere`.
/// If a prescribed quantity or one of its rates is used, all of them count as used.
inline base::sentence check_uses(const mechanics::multibody_system& system,
                                 const base::sequence<symbolic::expression>& elsewhere) {
  const mechanics::mechanism& m = system.mechanism;
  base::sequence<int> nodes;
  const auto collect = [&](const symbolic::expression& e) {
    if (e.belongs_to(*m.g)) nodes.push(e.node());
  };
  const each_expression each{collect};
  each(m.kinematics);
  each(m.frames);
  each(m.points);
  each(m.bodies);
  each(system.loads);
  each(system.constraints);
  each(elsewhere);
  base::sequence<char> used = symbolic::live_nodes(*m.g, nodes);
  for (int i = 0; i < 2; ++i) // towards higher rates, then back
    for (const mechanics::prescribed_rate& p : m.prescribed_rates) {
      char &quantity = used[p.quantity.node()], &rate = used[p.rate.node()];
      quantity = rate = static_cast<char>(quantity | rate);
    }
  struct list {
    std::string_view kind;
    const base::sequence<symbolic::expression>& symbols;
  };
  for (const list& l : {list{"parameter", m.parameters}, list{"input", m.inputs}})
    for (const symbolic::expression& e : l.symbols)
      if (used[e.node()] == 0)
        return base::sentence({l.kind, " ", m.g->symbol_at(e.node()).called.view(),
                               " is declared but not used in the system; if this is intended, call ",
                               "used_elsewhere"});
  for (const symbolic::expression& e : m.auxiliary_speeds)
    if (used[e.node()] == 0)
      return base::sentence({"auxiliary speed ", m.g->symbol_at(e.node()).called.view(),
                             " is declared but not used in the system"});
  return {};
}

} // namespace kanexpr::runtime
