#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/external.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/graph/substitute.hpp>
#include <kanexpr/symbolic/limits/point_evaluation.hpp>
#include <kanexpr/symbolic/limits/series_system.hpp>

#include <map>
#include <utility>
#include <vector>

namespace kanexpr::symbolic::limits {

/// The series of the nodes that the outputs need when the replaced symbols approach their point along a line:
/// a symbol replaced by x becomes x + ε d, with ε > 0.
class line {
public:
  /// `direction(id)` is the d of the symbol at node `id`; terms are kept up to the order `most`.
  template <class Direction>
  line(graph& g, const point_evaluation& point, substitution& plain, const sequence<int>& outputs,
       Direction direction, int most)
      : g_(g), point_(point), plain_(plain), most_(most) {
    for (int id : live_values(g, outputs)) {
      const operation op = g[id].op;
      if (op == operation::factorization) continue;
      found_.emplace(id,
                     op == operation::symbol && point.depends_on_replaced(id)
                         ? expansion(series::linear(replacing(id), coefficient(exactly(direction(id))), most))
                         : expand(id));
    }
  }

  const expansion& operator[](int id) const { return found_.at(id); }
  bool holds(int id) const { return found_.contains(id); }
  /// The first node without a series among those that a node depends on; the node itself if there is none.
  int first_failing_node(int id) const {
    const auto found = first_failing_node_.find(id);
    return found == first_failing_node_.end() ? id : found->second;
  }

private:
  coefficient plain(int id) const {
    if (g_.is_constant(id)) return coefficient(g_.number_at(id));
    return {plain_.in(expression{g_, id}), point_[id]};
  }
  coefficient replacing(int symbol) const {
    const expression by = point_.replacing(symbol)->by;
    if (by.is_constant()) return coefficient(g_.number_at(by.node()));
    return {by, point_[symbol]};
  }

  expansion expand(int id) {
    const node n = g_[id];
    if (!point_.is_singular(id) && !point_.depends_on_replaced(id)) return series(plain(id));
    if (n.op == operation::singularity_measure) return singularity_series(id);
    if (is_solution(n.op)) return solve(id, n);
    if (n.op == operation::call) return call(id, n);
    const expansion& a = found_.at(n.a);
    if (!a) return propagate_failure(id, n.a);
    if (n.op == operation::component)
      return solutions_.at(n.a)[static_cast<std::size_t>(integer_at(g_, n.b))];
    if (!is_binary(n.op)) return apply(n.op, *a, {});
    const expansion& b = found_.at(n.b);
    if (!b && is_selection(n.op) && never_selects(n.op, *a)) return series();
    if (!b) return propagate_failure(id, n.b);
    return apply(n.op, *a, *b);
  }

  static bool never_selects(operation op, const series& condition) {
    const expansion one = apply(op, condition, series(coefficient(1)));
    return one && one->is_zero();
  }

  expansion propagate_failure(int id, int operand) {
    first_failing_node_[id] = first_failing_node(operand);
    return found_.at(operand);
  }

  /// The singularity measure, which derivatives treat as a constant.
  expansion singularity_series(int id) {
    if (point_.is_singular(id)) return obstacle::truncated;
    return series(0, {plain(id)}, 1, most_);
  }

  expansion call(int id, const node& n) {
    std::vector<series> operands;
    for (int each : elements_of(g_, n.a)) {
      if (!found_.at(each)) return propagate_failure(id, each);
      operands.push_back(*found_.at(each));
    }
    const external_function& f = g_.external_at(id);
    return expand_call(g_, f, operands, most_);
  }

  /// The node of a complete solution represents its first component.
  expansion solve(int id, const node& n) {
    std::vector<series> a, b, x;
    const auto gather = [&](const sequence<int>& ids, std::vector<series>& all) {
      for (int each : ids) {
        if (!found_.at(each)) return each;
        all.push_back(*found_.at(each));
      }
      return -1;
    };
    int without = gather(entries_of(g_, n.a), a);
    if (without < 0) without = gather(elements_of(g_, n.b), b);
    if (without >= 0) return propagate_failure(id, without);
    const obstacle reason = series_system(g_, n.op, std::move(a), std::move(b)).solve(x);
    if (reason != obstacle::none) return reason;
    return solutions_.emplace(id, std::move(x)).first->second.front();
  }

  graph& g_;
  const point_evaluation& point_;
  substitution& plain_;
  int most_;
  std::map<int, expansion> found_{};
  std::map<int, std::vector<series>> solutions_{};
  std::map<int, int> first_failing_node_{};
};

} // namespace kanexpr::symbolic::limits
