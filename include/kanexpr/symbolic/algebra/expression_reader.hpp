#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/algebra/sum_of_terms.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/linear/expand_solves.hpp>
#include <kanexpr/symbolic/polynomials/budget.hpp>
#include <kanexpr/symbolic/polynomials/polynomial_fraction.hpp>

#include <vector>

namespace kanexpr::symbolic::algebra {

/// Whether a node is treated as a whole: its operands are lists, not values.
constexpr bool is_atomic(operation op) { return is_leaf(op) || op >= operation::pair; }

/// Reads expressions bottom-up as values of a form, which is derived from this class. A form provides
/// - `negative(a)`, `sum(a, b)`, `product(a, b)` and `quotient(a, b)`;
/// - `atomic(node)` for symbols, numbers and nodes treated as a whole, and `function(op, a, b)`;
/// - `size(a)`, the number of terms; `has_minus(a)`, whether it is written with a leading minus sign; and
///   `written(a)`, the expression.
template <class Value, class Form>
class expression_reader {
public:
  expression_reader(graph& g, budget& left) : g_(g), left_(left) {}

  /// Computes the value of each node once and discards it after its last use. Small linear systems are
  /// expanded. Returns nothing if the budget is exceeded.
  std::vector<Value> read(sequence<int> outputs) {
    if (const live_list live(g_, outputs); has_linear_systems(g_, live))
      outputs = expand_solves(g_, outputs, live);
    const int end = g_.size();
    count_uses(outputs);
    values_.assign(static_cast<std::size_t>(end), Value());
    std::size_t kept = 0;
    for (int id = 0; id < end; ++id) {
      if (at(uses_, id) == 0) continue;
      const node n = g_[id]; // a copy, since the graph may grow
      at(values_, id) = value(id, n);
      kept += form().size(at(values_, id));
      if (!left_.allows_total(kept)) return {};
      for (int operand : operands_of(n)) {
        if (--at(uses_, operand) > 0) continue;
        kept -= form().size(at(values_, operand));
        at(values_, operand) = Value();
      }
    }
    std::vector<Value> found;
    for (int id : outputs) found.push_back(at(values_, id));
    return found;
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

  template <class Entry>
  static Entry& at(std::vector<Entry>& by_node, int id) {
    return by_node[static_cast<std::size_t>(id)];
  }

  static sequence<int> operands_of(const node& n) {
    if (is_atomic(n.op)) return {};
    return is_binary(n.op) ? sequence<int>{n.a, n.b} : sequence<int>{n.a};
  }

  void count_uses(const sequence<int>& outputs) {
    uses_.assign(static_cast<std::size_t>(g_.size()), 0);
    for (int id : outputs) ++at(uses_, id);
    for (int id = g_.size() - 1; id >= 0; --id)
      if (at(uses_, id) != 0)
        for (int operand : operands_of(g_[id])) ++at(uses_, operand);
  }

  Value value(int id, const node& n) {
    if (is_atomic(n.op)) return form().atomic(id);
    const Value &a = at(values_, n.a), &b = at(values_, is_binary(n.op) ? n.b : graph::zero);
    if (n.op == operation::negate) return form().negative(a);
    if (n.op == operation::add) return form().sum(a, b);
    if (n.op == operation::subtract) return form().sum(a, form().negative(b));
    if (n.op == operation::multiply) return form().product(a, b);
    if (n.op == operation::divide) return form().quotient(a, b);
    return form().function(n.op, a, b);
  }

  graph& g_;
  budget& left_;
  std::vector<int> uses_{}; ///< by node: the number of uses not yet read
  std::vector<Value> values_{};
};

/// Reads expressions as fractions of polynomials. In addition to `has_minus` and `written`, a form provides
/// `known_function(op, fraction)`, which returns a numerator and a denominator for functions that it can
/// express, and `on_opaque_function(node)`, which is called for every function treated as a symbol.
template <class Coefficient, class Form>
class fraction_reader : public expression_reader<polynomials::fraction<Coefficient>, Form>,
                        public polynomials::fraction_arithmetic<Coefficient> {
public:
  using fraction = polynomials::fraction<Coefficient>;

  fraction_reader(graph& g, budget& left)
      : expression_reader<fraction, Form>(g, left), polynomials::fraction_arithmetic<Coefficient>(left) {}

  static std::size_t size(const fraction& a) { return a.numerator.size(); }
  fraction atomic(int id) {
    const polynomial<Coefficient> p = atom<Coefficient>({this->owner(), id});
    if (this->owner()[id].op != operation::symbol && !p.is_constant()) form().on_opaque_function(id);
    return {p, {}};
  }
  fraction function(operation op, const fraction& a, const fraction& b) {
    if (const auto known = form().known_function(op, a))
      return this->quotient({known->first, {}}, {known->second, {}});
    const unsigned_argument x = this->argument(a), y = this->argument(b);
    const polynomial<Coefficient> f = function_of<Coefficient>(op, x, y);
    if (f.is_constant()) return {f, {}};
    const int base = f.terms.front().factors.front().base;
    form().on_opaque_function(base);
    if (op == operation::sqrt) this->set_square(base, a);
    return {f, {}};
  }

private:
  Form& form() { return static_cast<Form&>(*this); }
};

} // namespace kanexpr::symbolic::algebra
