#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/loads/loads.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/graph/sum_shortening.hpp>

/// Simplification for models that specify positions or velocities by components with sines and cosines, such
/// as a ball in a trough. In such models, terms that frames would keep separate occur together: squared
/// velocities contain sin² + cos², and centripetal terms cancel.
namespace kanexpr::mechanics {

/// Whether a model specifies vectors by components with sines and cosines.
constexpr bool has_sines_in_components(const mechanism& m, const loads& acting) {
  sequence<int> nodes;
  const auto collect = [&](expression e) {
    if (!symbolic::is_leaf((*m.g)[e.node()].op)) nodes.push(e.node());
  };
  for (const point& p : m.points) {
    p.offset.each_entry(collect);
    p.velocity.each_entry(collect);
  }
  for (const frame& f : m.frames)
    if (f.kind == orientation::matrix)
      for (const expression& e : f.scalars()) collect(e);
  if (acting.has_lagrangian) collect(acting.lagrangian);
  if (nodes.empty()) return false;
  const base::zeros<char> live = symbolic::live_nodes(*m.g, nodes);
  const char* const is_live = live.begin(); // pointers, because compilers interpret every call
  const symbolic::node* const all = m.g->begin();
  for (int id = 0, end = live.size(); id < end; ++id)
    if (is_live[id] != 0 &&
        (all[id].op == symbolic::operation::sin || all[id].op == symbolic::operation::cos))
      return true;
  return false;
}

/// Returns the expressions with sin² + cos² replaced by 1, if they are shorter in total. `others` are
/// expressions that are needed in any case.
constexpr sequence<expression> gathered(graph& g, const sequence<expression>& all,
                                        const sequence<expression>& others = {}) {
  const sequence<int> nodes = symbolic::nodes_of(all), kept = symbolic::nodes_of(others);
  return symbolic::expressions_of(g, symbolic::shorten_sums(g, nodes, kept));
}

} // namespace kanexpr::mechanics
