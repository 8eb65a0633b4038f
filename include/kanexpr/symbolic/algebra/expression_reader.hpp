#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/algebra/sum_of_terms.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/linear/expand_solves.hpp>
#include <kanexpr/symbolic/polynomials/budget.hpp>

#include <vector>

namespace kanexpr::symbolic::algebra {

/// Whether a node is treated as a whole: its operands are lists, not values.
constexpr bool is_atomic(operation op) { return is_leaf(op) || op >= operation::pair; }

/// Computes a value for every node below some outputs exactly once, and discards it after its last use.
/// `value_of(id, a, b)` receives the values of the operands; `size_of` returns the number of terms of a
/// value. Returns nothing if the budget is exceeded.
template <class Value, class ValueOf, class SizeOf>
std::vector<Value> bottom_up(const graph& g, const sequence<int>& outputs, budget& left, SizeOf size_of,
                             ValueOf value_of) {
  const auto at = [](auto& all, int id) -> auto& { return all[static_cast<std::size_t>(id)]; };
  const int end = g.size();
  std::vector<int> uses(static_cast<std::size_t>(end), 0);
  for (int id : outputs) ++at(uses, id);
  for (int id = end - 1; id >= 0; --id) {
    const node& n = g[id];
    if (at(uses, id) == 0 || is_atomic(n.op)) continue;
    ++at(uses, n.a);
    if (is_binary(n.op)) ++at(uses, n.b);
  }
  std::vector<Value> values(static_cast<std::size_t>(end));
  std::size_t kept = 0;
  const auto release = [&](int id) {
    if (--at(uses, id) > 0) return;
    kept -= size_of(at(values, id));
    at(values, id) = Value();
  };
  for (int id = 0; id < end; ++id) {
    if (at(uses, id) == 0) continue;
    const node n = g[id]; // a copy, since the graph may grow
    const bool has_operands = !is_atomic(n.op);
    const int second = has_operands && is_binary(n.op) ? n.b : graph::zero;
    at(values, id) = value_of(id, has_operands ? at(values, n.a) : Value(), at(values, second));
    kept += size_of(at(values, id));
    if (!left.allows_total(kept)) return {};
    if (has_operands) release(n.a);
    if (has_operands && is_binary(n.op)) release(n.b);
  }
  std::vector<Value> found;
  for (int id : outputs) found.push_back(at(values, id));
  return found;
}

/// Reads expressions bottom-up as values of a form, which is derived from this class. A form provides
/// - `negative(a)`, `sum(a, b)`, `product(a, b)` and `quotient(a, b)`;
/// - `atomic(node)` for symbols, numbers and nodes treated as a whole, and `function(op, a, b)`;
/// - `size(a)`, the number of terms; `has_minus(a)`, whether a minus is written in front; and `written(a)`,
///   the expression.
template <class Value, class Form>
class expression_reader {
public:
  expression_reader(graph& g, budget& left) : g_(g), left_(left) {}

  /// Small linear systems are expanded. Returns nothing if the budget is exceeded.
  std::vector<Value> read(const sequence<int>& outputs) {
    const bool has_systems = holds_solves(g_, live_nodes(g_, outputs));
    return bottom_up<Value>(
        g_, has_systems ? expand_solves(g_, outputs) : outputs, left_,
        [this](const Value& a) { return form().size(a); },
        [this](int id, const Value& a, const Value& b) { return value(id, a, b); });
  }

protected:
  graph& owner() const { return g_; }
  budget& left() const { return left_; }

  /// A function argument with its sign split off.
  unsigned_argument argument(const Value& a) {
    const bool negative = form().has_minus(a);
    return {form().written(negative ? form().negative(a) : a), negative};
  }

private:
  Form& form() { return static_cast<Form&>(*this); }

  Value value(int id, const Value& a, const Value& b) {
    const operation op = g_[id].op;
    if (op == operation::negate) return form().negative(a);
    if (op == operation::add) return form().sum(a, b);
    if (op == operation::subtract) return form().sum(a, form().negative(b));
    if (op == operation::multiply) return form().product(a, b);
    if (op == operation::divide) return form().quotient(a, b);
    return is_atomic(op) ? form().atomic(id) : form().function(op, a, b);
  }

  graph& g_;
  budget& left_;
};

} // namespace kanexpr::symbolic::algebra
