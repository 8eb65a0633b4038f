#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/graph/substitute.hpp>
#include <kanexpr/symbolic/limits/external_series.hpp>

#include <map>
#include <utility>
#include <vector>

namespace kanexpr::symbolic::limits {

/// The values of the nodes that the outputs need when symbols are replaced simultaneously, with a record of
/// the nodes that are undefined there.
class point_evaluation {
public:
  point_evaluation(const graph& g, const sequence<int>& outputs, const std::vector<replacement>& point)
      : g_(g), place_(g.size(), -1) {
    const base::zeros<char> live = live_nodes(g, outputs);
    int count = 0;
    for (int id = 0; id < g.size(); ++id)
      if (live[id] != 0) place_[id] = count++;
    known_.resize(static_cast<std::size_t>(count));
    if (!point.empty()) replace(point);
    for (int id = 0; id < g.size(); ++id)
      if (live[id] != 0) evaluate(id);
  }

  const generic_values& operator[](int id) const { return at(id).values; }
  /// Whether a node depends on a replaced symbol.
  bool depends_on_replaced(int id) const { return at(id).moved; }
  /// Whether plain substitution leaves a node, or a node that it depends on, undefined.
  bool is_singular(int id) const { return at(id).singular; }
  /// The replacement of a symbol, or null if it is not replaced.
  const replacement* replacing(int symbol) const {
    const auto found = by_symbol_.find(symbol);
    return found == by_symbol_.end() ? nullptr : found->second;
  }

private:
  struct node_result {
    generic_values values{};
    bool moved = false;
    bool singular = false;
  };

  const node_result& at(int id) const { return known_[static_cast<std::size_t>(place_[id])]; }
  node_result& at(int id) { return known_[static_cast<std::size_t>(place_[id])]; }

  void replace(const std::vector<replacement>& point) {
    sequence<int> replacing;
    for (const replacement& each : point) replacing.push(each.by.node());
    const point_evaluation of_those(g_, replacing, {});
    for (const replacement& each : point) {
      by_symbol_[each.symbol.node()] = &each;
      if (place_[each.symbol.node()] < 0) continue;
      node_result& known = at(each.symbol.node());
      known.moved = true;
      known.values = of_those[each.by.node()];
    }
  }

  void evaluate(int id) {
    const node& n = g_[id];
    node_result& known = at(id);
    if (n.op == operation::constant) known.values = generic_values(bounded::of(g_.number_at(id)));
    if (n.op == operation::symbol && !known.moved)
      known.values = generic_values::of_symbol(g_.symbol_at(id).kind, n.a);
    if (is_leaf(n.op)) return;
    const bool has_second = is_binary(n.op) && (n.op < operation::pair || is_value(n));
    const node_result &a = at(n.a), &b = has_second ? at(n.b) : none_;
    known.moved = a.moved || b.moved;
    known.singular = a.singular || (b.singular && !(is_selection(n.op) && never_selects(n.op, a.values)));
    if (is_solution(n.op)) return solve(id, known);
    if (n.op == operation::call) return call(id, known);
    if (n.op == operation::component)
      known.values = known.singular ? undefined_ : solutions_[n.a][component_of(n)];
    else if (n.op >= operation::pair)
      known.values = undefined_;
    else
      calculate(n.op, a.values, b.values, known);
  }

  void calculate(operation op, const generic_values& a, const generic_values& b, node_result& known) const {
    known.values = apply(op, a, b);
    const bool is_unreal = known.values.is_number() && !known.values.defined();
    known.singular = known.singular || is_unreal || limits::is_singular(op, a, b);
  }

  void call(int id, node_result& known) const {
    known.values = undefined_;
    if (known.singular) return;
    std::vector<generic_values> operands;
    for (int each : elements_of(g_, g_[id].a)) operands.push_back((*this)[each]);
    known.values = call_values(g_.external_at(id), operands);
  }

  void solve(int id, node_result& known) {
    if (known.singular) return;
    const node& n = g_[id];
    const int order = order_of(g_, n.a);
    std::vector<generic_values> a, b;
    const sequence<int> entries = entries_of(g_, n.a);
    for (int i = 0; i < order; ++i)
      for (int j = 0; j < order; ++j)
        a.push_back((*this)[entries[n.op == operation::solve ? i * order + j : j * order + i]]);
    for (int right : elements_of(g_, n.b)) b.push_back((*this)[right]);
    if (auto x = solved(a, b))
      solutions_[id] = *std::move(x);
    else
      known.singular = true;
  }

  std::size_t component_of(const node& n) const { return static_cast<std::size_t>(integer_at(g_, n.b)); }

  const graph& g_;
  sequence<int> place_;              ///< by node; -1: not needed
  std::vector<node_result> known_{}; ///< indexed by `place_`
  std::map<int, const replacement*> by_symbol_{};
  std::map<int, std::vector<generic_values>> solutions_{};
  node_result none_{};
  generic_values undefined_{bounded::undefined()};
};

} // namespace kanexpr::symbolic::limits
