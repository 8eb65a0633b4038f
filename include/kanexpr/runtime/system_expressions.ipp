#pragma once

#include <kanexpr/base/members.hpp>
#include <kanexpr/base/name.hpp>
#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/multibody_system.hpp>
#include <kanexpr/symbolic/graph/canonical_order.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/live_nodes.hpp>

#include <optional>
#include <string_view>
#include <type_traits>

namespace kanexpr::runtime {

/// Calls `use` for each expression of a system or of one of its parts, in the order of the members.
template <class Use>
class each_expression {
public:
  explicit each_expression(const Use& use) : use_(use) {}

  template <class Part>
  void operator()(Part& part) const {
    if constexpr (std::is_scalar_v<Part>)
      return;
    else
      for_each_member(part, *this);
  }
  template <class... Parts>
    requires(sizeof...(Parts) > 1)
  void operator()(Parts&... parts) const {
    ((*this)(parts), ...);
  }
  template <class Part>
  void operator()(base::sequence<Part>& parts) const {
    for (Part& each : parts) (*this)(each);
  }
  template <class Part>
  void operator()(const base::sequence<Part>& parts) const {
    for (const Part& each : parts) (*this)(each);
  }
  template <class Part>
  void operator()(std::optional<Part>& part) const {
    if (part) (*this)(*part);
  }
  template <class Part>
  void operator()(const std::optional<Part>& part) const {
    if (part) (*this)(*part);
  }
  void operator()(symbolic::expression& e) const { use_(e); }
  void operator()(const symbolic::expression& e) const { use_(e); }
  void operator()(base::name&) const {}
  void operator()(const base::name&) const {}

private:
  const Use& use_;
};

/// Copies the expressions of a system to a separate graph. The numbering of nodes in the graph of a builder,
/// which its models share, depends on the order in which the compiler evaluates operands; in a separate
/// graph, it does not.
inline void copy_to_graph(symbolic::graph& own, mechanics::multibody_system& system) {
  const symbolic::graph& shared = *system.mechanism.g;
  base::sequence<int> nodes;
  const auto collect = [&](const symbolic::expression& e) {
    if (e.belongs_to(shared)) nodes.push(e.node());
  };
  each_expression{collect}(system);
  const base::sequence<int> place = symbolic::copy_nodes(shared, nodes, own);
  const auto move = [&](symbolic::expression& e) {
    if (e.belongs_to(shared)) e = {own, place[e.node()]};
  };
  each_expression{move}(system);
  system.mechanism.g = &own;
}

/// Reports a parameter, an input or an auxiliary speed that is used neither in the system nor in `elsewhere`.
/// If a prescribed quantity or one of its rates is used, all of them count as used.
inline base::sentence check_unused_symbols(const mechanics::multibody_system& system,
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
  each(m.flexible_bodies);
  each(system.loads);
  each(system.constraints);
  each(elsewhere);
  base::zeros<char> used = symbolic::live_nodes(*m.g, nodes);
  for (int i = 0; i < 2; ++i) // toward higher rates, then back
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
