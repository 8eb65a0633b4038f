#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/base/zeros.hpp>
#include <kanexpr/symbolic/graph/function_table.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/live_nodes.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

/// Finds results that can become infinite or NaN even though all values they depend on are finite and of
/// ordinary size.
namespace kanexpr::symbolic {

/// Determines which outputs must be checked to be sure that all are finite. Roots, functions and quotients
/// can produce infinity or NaN, except quotients whose divisor is in `sure_divisors`. Sums and products are
/// ignored: they overflow only at values of no practical use.
class finiteness {
  // precedes its callers, because clang++ does not instantiate a template for a constant expression if it is
  // declared later in the class
  template <class Nodes, class List, class Facts>
  constexpr void classify_all(const Nodes& nodes, const List& live, Facts& facts) {
    for (int i = live_.count - 1; i >= 0; --i) { // operands first
      const int id = live[i];
      const operation op = nodes[id].op;
      if (op != operation::add && op != operation::subtract && op != operation::multiply) {
        if (op != operation::symbol) classify(id);
        continue;
      }
      // most nodes, handled inline because compilers interpret every call
      const int a = nodes[id].a, b = nodes[id].b, both = facts[a] & facts[b], any = facts[a] | facts[b];
      if ((any & may_fail) != 0) facts[id] |= may_fail, any_fails_ = true;
      const bool is_square = op == operation::multiply && a == b;
      if (is_square || (op != operation::subtract && (both & never_negative) != 0))
        facts[id] |= never_negative;
    }
  }

public:
  /// `live` are the live nodes of the outputs. Both must outlive it.
  constexpr finiteness(const graph& g, const sequence<int>& outputs, const live_list& live,
                       const sequence<int>& sure_divisors)
      : nodes_(g.begin()), size_(g.size()), g_(g), outputs_(outputs), live_(live), facts_(g.size()),
        facts_of_(facts_.begin()) {
    for (int id : sure_divisors) facts_of_[id] = sure;
    if (__builtin_is_constant_evaluated())
      classify_all(g.elements<true>(), live_.nodes.elements<true>(), facts_.elements<true>());
    else
      classify_all(g.elements<false>(), live_.nodes.elements<false>(), facts_.elements<false>());
  }
  finiteness(const finiteness&) = delete;
  finiteness& operator=(const finiteness&) = delete;

  /// The minimal set of outputs to check: if one is not finite, neither are sums or products of it.
  constexpr sequence<int> outputs_to_check() const {
    if (!any_fails_) return {};
    base::zeros<char> is_covered(size_), is_output(size_);
    char* const covered = is_covered.begin();
    char* const output = is_output.begin();
    for (int id : outputs_) output[id] = 1;
    sequence<int> some;
    const int* const live = live_.nodes.begin();
    for (int i = 0; i < live_.count; ++i) {
      const int id = live[i];
      if ((facts_of_[id] & may_fail) == 0) continue;
      if (output[id] != 0 && covered[id] == 0) {
        some.push(id);
        covered[id] = 1;
      }
      if (covered[id] != 0) propagate(nodes_[id], covered);
    }
    return some;
  }

  /// The symbols in the divisors, roots and arguments where infinity or NaN may originate, except divisors
  /// that are checked elsewhere.
  constexpr sequence<int> suspicious_symbols(const sequence<int>& known_divisors) const {
    if (!any_originates_) return {};
    base::zeros<char> is_known(size_), is_reached(size_);
    char* const reached = is_reached.begin();
    for (int id : known_divisors) is_known[id] = 1;
    const int* const live = live_.nodes.begin();
    sequence<int> symbols;
    for (int i = 0; i < live_.count; ++i) {
      const int id = live[i];
      if (reached[id] == 0 && (facts_of_[id] & originates) == 0) continue;
      const node& n = nodes_[id];
      if (n.op == operation::symbol) symbols.push(id);
      if (is_leaf(n.op)) continue;
      const bool has_second = is_binary(n.op) && !has_index_operand(n.op);
      if (reached[id] != 0 || n.op != operation::divide) reached[n.a] = 1;
      if (has_second && (reached[id] != 0 || is_known[n.b] == 0)) reached[n.b] = 1;
    }
    for (int i = 0, j = symbols.size() - 1; i < j; ++i, --j) { // in ascending order
      const int last = symbols[j];
      symbols[j] = symbols[i], symbols[i] = last;
    }
    return symbols;
  }

  /// Whether the outputs contain a number that is not finite, such as the reciprocal of a tiny mass.
  constexpr bool has_infinite_number() const { return has_infinite_number_; }

private:
  /// Properties of a live node, as bits.
  enum fact : int { sure = 1, never_negative = 2, originates = 4, may_fail = 8 };

  constexpr void classify(int id) { // writes only bits that are set, because compilers are slow here
    const node& n = nodes_[id];
    const int a = facts_of_[n.a], b = is_binary(n.op) && !has_index_operand(n.op) ? facts_of_[n.b] : a;
    int found = (a | b) & may_fail;
    switch (form_of(n.op)) {
    case form::leaf:
      if (!g_.is_constant(id)) return;
      if (!is_finite(g_.number_at(id)))
        facts_of_[id] |= may_fail, any_fails_ = has_infinite_number_ = true;
      else if (!g_.number_at(id).negative())
        facts_of_[id] |= never_negative;
      return;
    case form::divide:
      if (!g_.is_constant(n.b) && (b & sure) == 0) found |= originates;
      break;
    case form::function: {
      const function_properties& f = properties_of(n.op);
      if (f.never_negative) found |= never_negative;
      if (n.op == operation::sqrt ? (a & never_negative) == 0
                                  : !f.stays_finite) // the argument may be rounded below 0
        found |= originates;
      break;
    }
    case form::binary_function:
      if (!binary_properties_of(n.op).stays_finite) found |= originates;
      break;
    case form::power: found |= originates; break;
    case form::selection: found |= b & never_negative; break;
    case form::list_operation:
      if (n.op == operation::symmetric_solve || n.op == operation::pair ||
          g_[n.a].op == operation::symmetric_solve)
        break;                                                             // sums and products
      found |= n.op == operation::call ? originates | may_fail : may_fail; // the result has a separate status
      break;
    case form::negate:
    case form::add: // handled above
    case form::subtract:
    case form::multiply: break;
    }
    if ((found & originates) != 0) found |= may_fail, any_originates_ = true;
    if ((found & may_fail) != 0) any_fails_ = true;
    if (found != 0) facts_of_[id] |= found;
  }

  /// Marks the operands that, if they are not finite, make the result not finite.
  static constexpr void propagate(const node& n, char* is_covered) {
    switch (form_of(n.op)) {
    case form::add:
    case form::subtract:
    case form::multiply: is_covered[n.b] = is_covered[n.a] = 1; break;
    case form::divide: // 1/∞ is 0
    case form::negate: is_covered[n.a] = 1; break;
    case form::function:
      if (properties_of(n.op).passes_infinity) is_covered[n.a] = 1;
      break;
    case form::leaf:
    case form::power:
    case form::binary_function:
    case form::selection:
    case form::list_operation: break; // the result may still be finite
    }
  }

  const node* nodes_;
  int size_;
  const graph& g_;
  const sequence<int>& outputs_;
  const live_list& live_;
  base::zeros<int> facts_; ///< by node
  int* facts_of_;
  bool any_originates_ = false, any_fails_ = false, has_infinite_number_ = false;
};

/// A sum built without simplification, so that no terms cancel.
constexpr int unsimplified_sum(graph& g, const sequence<int>& nodes) {
  int sum = nodes[0];
  for (int i = 1; i < nodes.size(); ++i)
    sum =
        g.find_or_append({operation::add, sum < nodes[i] ? sum : nodes[i], sum < nodes[i] ? nodes[i] : sum});
  return sum;
}

/// Whether nodes depend on symbols only through sines and cosines, so that no symbol can make them large.
constexpr bool depend_only_on_angles(const graph& g, const sequence<int>& nodes) {
  base::zeros<char> is_reached(g.size());
  char* const reached = is_reached.begin();
  const node* const all = g.begin();
  for (int id : nodes) reached[id] = 1;
  for (int id = g.size() - 1; id >= 0; --id) {
    if (reached[id] == 0) continue;
    const node& n = all[id];
    if (n.op == operation::sin || n.op == operation::cos) continue;
    if (n.op == operation::symbol) return false;
    if (is_leaf(n.op)) continue;
    reached[n.a] = 1;
    if (is_binary(n.op) && !has_index_operand(n.op)) reached[n.b] = 1;
  }
  return true;
}

} // namespace kanexpr::symbolic
