#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/limits/limit.hpp>
#include <kanexpr/symbolic/limits/limit_diagnostics.hpp>
#include <kanexpr/symbolic/limits/point_evaluation.hpp>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace kanexpr::symbolic {

namespace limits {

/// Straight lines toward a point, given by the steps of the replaced symbols. A single symbol approaches the
/// point from both sides. With several symbols, any two of them have steps of opposite signs on some line,
/// and each has the larger step on some line. The last line has equal steps, which give the shortest
/// expressions; it may be a special case.
class directions {
public:
  /// Covers the replaced symbols that the outputs depend on.
  directions(const graph& g, const point_evaluation& point, const sequence<int>& outputs) {
    for (int id : live_values(g, outputs))
      if (g[id].op == operation::symbol && point.depends_on_replaced(id)) replaced_.push(id);
    for (int separated = 1; separated < replaced_.size(); separated *= 2) ++sign_patterns_;
  }

  int size() const { return replaced_.size() == 1 ? 2 : mixed + sign_patterns_ + 1; }
  bool has_equal_steps() const { return replaced_.size() > 1; }

  /// The step of a symbol along a line; the ratios of steps are not simple fractions.
  int step(int way, int symbol) const {
    if (replaced_.size() == 1) return way == 0 ? 1 : -1;
    if (way == size() - 1) return 1;
    const int i = replaced_.find(symbol);
    const int shrinking = replaced_.size() - 1 - i, growing = 2 * i * i + 7 * i + 3 + way;
    switch (way) {
    case 0: return (i % 2 == 1 ? -1 : 1) * (3 * i * i + 5 * i + 2);
    case 1: return (i % 2 == 1 ? 1 : -1) * (3 * i * i + 5 * i + 2);
    case 2: return 2 * i * i + 5 * i + 1;
    case 3: return 2 * shrinking * shrinking + 3 * shrinking + 1;
    default: return (i >> (way - mixed)) % 2 == 1 ? -growing : growing;
    }
  }

private:
  static constexpr int mixed = 4;

  sequence<int> replaced_{};
  int sign_patterns_ = 0;
};

struct limit {
  expression value{};
  std::string condition{}; ///< empty if the value was found
};

/// Limits of expressions for which substitution gives no value. The point is approached along straight lines
/// from several sides; there is no limit if the results differ.
class limits {
public:
  limits(graph& g, const point_evaluation& point, substitution& plain, const sequence<int>& outputs)
      : g_(g), point_(point), plain_(plain), diagnostics_(g, point), ways_(g, point, outputs) {
    if (!outputs.empty()) search(defined_outputs(outputs));
  }

  const limit& operator[](int id) const { return found_.at(id); }

private:
  using lines = std::vector<std::unique_ptr<line>>;
  static constexpr int most_terms = 16;

  /// Returns the outputs that have values somewhere; reports the others as failures.
  sequence<int> defined_outputs(const sequence<int>& outputs) {
    const point_evaluation generic(g_, outputs, {});
    sequence<int> others;
    for (int id : outputs)
      if (generic.is_singular(id))
        fail(id, diagnostics_.describe_undefined_everywhere(generic, id));
      else
        others.push(id);
    return others;
  }

  /// Adds terms to the series until every limit is decided.
  void search(sequence<int> open) {
    for (int most = 2; !open.empty() && most <= most_terms; most *= 2) {
      lines all;
      all.push_back(line_along(0, open, most));
      sequence<int> candidates, undecided;
      for (int id : open) (is_truncated(*all[0], id) && most < most_terms ? undecided : candidates).push(id);
      for (int way = 1; way < ways_.size() && !candidates.empty(); ++way)
        all.push_back(line_along(way, candidates, most));
      for (int id : candidates)
        if (!decide(all, id, most == most_terms)) undecided.push(id);
      open = undecided;
    }
  }

  std::unique_ptr<line> line_along(int way, const sequence<int>& outputs, int most) const {
    return std::make_unique<line>(
        g_, point_, plain_, outputs, [&](int symbol) { return ways_.step(way, symbol); }, most);
  }

  static bool has_pole(const line& l, int id) { return l[id]->has_terms() && l[id]->order() < 0; }
  static bool is_truncated(const line& l, int id) {
    return l[id] ? !has_pole(l, id) && l[id]->end() <= 0 : l[id].reason() == obstacle::truncated;
  }
  /// Along a line on which a denominator happens to vanish, nothing can be decided.
  static bool is_conclusive(const line& l, int id) {
    const obstacle reason = l[id].reason();
    return reason != obstacle::zero_divisor && reason != obstacle::singular_system && !is_truncated(l, id);
  }
  static bool differ(const line& a, const line& b, int id) { return !((*a[id])[0] - (*b[id])[0]).is_zero(); }

  /// Finds a limit or the reason why there is none; returns false if more terms may change the result.
  bool decide(const lines& all, int id, bool is_last) {
    const line* first = nullptr;
    bool is_open = false;
    for (const std::unique_ptr<line>& each : all) {
      const std::string condition = is_conclusive(*each, id) ? limit_failure(first, *each, id) : "";
      if (!condition.empty()) return fail(id, condition);
      if (first == nullptr && is_conclusive(*each, id)) first = each.get();
      const bool is_special = ways_.has_equal_steps() && each == all.back();
      is_open = is_open || (is_truncated(*each, id) && !is_special);
    }
    if (is_open && !is_last) return false;
    if (first == nullptr) return fail(id, diagnostics_.describe_missing_series(*all.front(), id));
    const bool is_simple = ways_.has_equal_steps() && is_conclusive(*all.back(), id);
    found_[id] = {(*(is_simple ? *all.back() : *first)[id])[0].in(g_), {}};
    return true;
  }

  /// The reason why there is no limit, from a conclusive line and an earlier one; empty if they agree.
  std::string limit_failure(const line* first, const line& other, int id) const {
    if (!other[id]) return diagnostics_.describe_missing_series(other, id);
    if (has_pole(other, id)) return diagnostics_.describe_pole(other, id);
    if (first == nullptr || !differ(*first, other, id)) return {};
    return diagnostics_.describe_direction(first_that_differs(*first, other, id));
  }

  int first_that_differs(const line& a, const line& b, int id) const {
    const auto is_finite = [](const line& l, int each) {
      return l.holds(each) && l[each] && !has_pole(l, each) && l[each]->end() > 0;
    };
    for (int each : live_values(g_, {id}))
      if (is_finite(a, each) && is_finite(b, each) && differ(a, b, each)) return each;
    return id;
  }

  bool fail(int id, const std::string& condition) {
    found_[id] = {constant(g_, real(std::numeric_limits<double>::quiet_NaN())), condition};
    return true;
  }

  graph& g_;
  const point_evaluation& point_;
  substitution& plain_;
  limit_diagnostics diagnostics_;
  directions ways_;
  std::map<int, limit> found_{};
};

} // namespace limits

KANEXPR_ENGINE point_values limits_at(graph& g, const matrix& m, const std::vector<replacement>& point) {
  const sequence<int> outputs = nodes_of(m.entries);
  const limits::point_evaluation at(g, outputs, point);
  substitution plain(g);
  for (const replacement& each : point) plain.replace(each.symbol, each.by);
  sequence<int> without_value;
  for (int id : outputs)
    if (at.is_singular(id) && !without_value.contains(id)) without_value.push(id);
  const limits::limits limits(g, at, plain, without_value);
  point_values found{m, {}};
  for (int i = 0; i < outputs.size(); ++i) {
    expression& value = found.values.entries[i];
    if (!at.is_singular(outputs[i])) {
      value = plain.in(value);
      continue;
    }
    const limits::limit& limit = limits[outputs[i]];
    value = limit.value;
    if (!limit.condition.empty()) found.singular.push_back({i / m.columns, i % m.columns, limit.condition});
  }
  return found;
}

} // namespace kanexpr::symbolic
