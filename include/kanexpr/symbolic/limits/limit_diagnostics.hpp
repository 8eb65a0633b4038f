#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/function_table.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/limits/line.hpp>
#include <kanexpr/symbolic/printing/print.hpp>

#include <string>

namespace kanexpr::symbolic::limits {

/// Describes why an expression has no limit, in a message that names the part that fails.
class limit_diagnostics {
public:
  limit_diagnostics(const graph& g, const point_evaluation& point) : g_(g), point_(point) {}

  /// For a node that has no series along a line.
  std::string describe_missing_series(const line& l, int id) const {
    id = l.first_failing_node(id);
    switch (l[id].reason()) {
    case obstacle::none:
    case obstacle::truncated: return "no limit was found with " + terms_known(id) + where(id);
    case obstacle::zero_divisor:
    case obstacle::singular_system: return describe_undefined(id);
    case obstacle::piecewise:
      return function(id) + " depends on the signs of the remaining symbols" + where(id);
    case obstacle::zero_logarithm: return function(id) + " is not finite" + where(id);
    case obstacle::infinite_argument: return "the argument of " + function(id) + " is not finite" + where(id);
    case obstacle::not_real: return function(id) + " is not real" + where(id);
    case obstacle::fractional_order: return function(id) + " has no derivative" + where(id);
    }
    return {};
  }

  /// For a node that is undefined even at generic values of all symbols.
  std::string describe_undefined_everywhere(const point_evaluation& generic, int id) const {
    for (int each : live_values(g_, {id}))
      if (generic.is_singular(each)) return describe_undefined(each);
    return describe_undefined(id);
  }

  /// For a node that tends to infinity along a line.
  std::string describe_pole(const line& l, int id) const {
    for (;;) {
      const node& n = g_[id];
      const int operand = steepest(l, n);
      if (operand >= 0) {
        id = operand;
        continue;
      }
      if (n.op == operation::divide) return denominator(n.b) + " vanishes" + where(n.b);
      if (is_solution(n.op)) return system(n.a) + " is singular" + where(n.a);
      return function(id) + " is not finite" + where(id);
    }
  }

  std::string describe_direction(int id) const {
    const std::string text = text_if_short(id);
    return (text.empty() ? "the limit" : "the limit of " + text) + where(id) + " depends on the direction";
  }

private:
  static constexpr std::size_t max_text_length = 60;

  std::string describe_undefined(int id) const {
    const node& n = g_[id];
    if (n.op == operation::divide) return denominator(n.b) + " vanishes identically";
    return is_solution(n.op) ? system(n.a) + " is singular everywhere"
                             : function(id) + " is undefined everywhere";
  }

  /// The extent of the series, which is limited by the derivatives that user-defined functions provide.
  std::string terms_known(int id) const {
    for (int each : live_values(g_, {id}))
      if (g_[each].op == operation::call)
        return "the given derivatives of " + std::string(g_.external_at(each).original.view());
    return "16 series terms";
  }

  /// The operand with the pole of the highest order; -1 if no operand has a pole.
  int steepest(const line& l, const node& n) const {
    sequence<int> operands;
    if (n.op == operation::call) {
      append_elements(g_, n.a, operands);
    } else if (is_solution(n.op)) {
      operands = entries_of(g_, n.a);
      append_elements(g_, n.b, operands);
    } else {
      operands.push(n.a);
      if (is_binary(n.op) && !has_index_operand(n.op)) operands.push(n.b);
    }
    int found = -1, least = 0;
    for (int each : operands)
      if (l.holds(each) && l[each] && l[each]->has_terms() && l[each]->order() < least)
        found = each, least = l[each]->order();
    // a component leads to the whole solution
    return found < 0 && n.op == operation::component ? n.a : found;
  }

  std::string denominator(int id) const {
    const std::string text = text_if_short(id);
    return text.empty() ? "a denominator" : text + " in a denominator";
  }
  /// A formula, or only the function name if the formula is too long.
  std::string function(int id) const {
    std::string text = text_if_short(id);
    if (!text.empty()) return text;
    const node& n = g_[id];
    if (n.op == operation::power) return "a power";
    if (n.op == operation::call) return std::string(g_.external_at(id).called.view()) + "(...)";
    return *function_name(n.op) == '\0' ? "a part" : std::string(function_name(n.op)) + "(...)";
  }
  std::string system(int factorization) const {
    const int order = order_of(g_, factorization);
    const sequence<int> entries = entries_of(g_, factorization);
    std::string text = "the linear system with [";
    for (int i = 0; i < order * order; ++i) {
      const std::string entry = text_if_short(entries[i]);
      if (entry.empty() || text.size() + entry.size() > 2 * max_text_length)
        return "a linear system of order " + std::to_string(order);
      text += (i % order != 0 ? ", " : i == 0 ? "[" : "], [") + entry;
    }
    return text + "]]";
  }

  /// " at q1 = 0, q2 = pi": the replaced symbols in a node.
  std::string where(int id) const {
    constexpr int most_symbols = 6;
    std::string text;
    int count = 0;
    for (int each : live_values(g_, {id})) {
      if (g_[each].op != operation::symbol) continue;
      const replacement* const r = point_.replacing(each);
      if (r == nullptr) continue;
      if (++count > most_symbols) return text + ", ...";
      const std::string by = text_if_short(r->by.node());
      text += (count == 1 ? " at " : ", ") + print(g_, each) + " = " + (by.empty() ? "..." : by);
    }
    return text;
  }

  /// The printed form, or nothing if it would be too long; the length is estimated before printing.
  std::string text_if_short(int id) const {
    int left = static_cast<int>(max_text_length);
    if (!fits(id, left)) return {};
    const std::string text = print(g_, id);
    return text.size() > max_text_length ? std::string{} : text;
  }
  /// Whether the expression tree has at most `left` nodes.
  bool fits(int id, int& left) const {
    if (--left < 0) return false;
    const node& n = g_[id];
    return is_leaf(n.op) || (fits(n.a, left) && (!is_binary(n.op) || fits(n.b, left)));
  }

  const graph& g_;
  const point_evaluation& point_;
};

} // namespace kanexpr::symbolic::limits
