#pragma once

#include <kanexpr/symbolic/graph/live_nodes.hpp>

/// Where results may leave the finite numbers though all that they rest on is finite, and of a usual size.
namespace kanexpr::symbolic {

/// Which of some outputs have to be looked at to know that all are finite, where quotients, roots and
/// functions may leave the finite numbers; divisions by `sure_divisors` do not. Sums and products do not
/// count: they overflow only at values that nobody uses.
class finiteness {
public:
  constexpr finiteness(const graph& g, const sequence<int>& outputs, const sequence<int>& sure_divisors)
      : g_(g), outputs_(outputs), live_(live_nodes(g, outputs)), is_sure_(g.size(), 0),
        is_never_negative_(g.size(), 0), begins_(g.size(), 0), may_fail_(g.size(), 0) {
    for (int id : sure_divisors) is_sure_[id] = 1;
    for (int id = 0; id < g.size(); ++id)
      if (live_[id] != 0) look_at(id);
  }

  /// As few outputs as will do: where one is not finite, neither is what is a sum or product of it.
  constexpr sequence<int> watched() const {
    sequence<char> is_told(g_.size(), 0), is_output(g_.size(), 0);
    for (int id : outputs_) is_output[id] = 1;
    sequence<int> some;
    for (int id = g_.size() - 1; id >= 0; --id) { // who uses a node comes after it
      if (live_[id] == 0 || may_fail_[id] == 0) continue;
      if (is_output[id] != 0 && is_told[id] == 0) {
        some.push(id);
        is_told[id] = 1;
      }
      if (is_told[id] != 0) pass_on(g_[id], is_told);
    }
    return some;
  }

  /// The symbols in divisors, roots and arguments that leave the finite numbers first, but for divisors that
  /// something else looks at.
  constexpr sequence<int> suspects(const sequence<int>& known_divisors) const {
    if (!any_begins_) return {};
    sequence<char> is_known(g_.size(), 0), reached(g_.size(), 0);
    for (int id : known_divisors) is_known[id] = 1;
    for (int id = g_.size() - 1; id >= 0; --id) {
      const node& n = g_[id];
      if (is_leaf(n.op) || !(begins_[id] != 0 || reached[id] != 0)) continue;
      const bool has_second = is_binary(n.op) && !is_numbered(n.op);
      if (reached[id] != 0 || n.op != operation::divide) reached[n.a] = 1;
      if (has_second && (reached[id] != 0 || is_known[n.b] == 0)) reached[n.b] = 1;
    }
    sequence<int> symbols;
    for (int id = 0; id < g_.size(); ++id)
      if (reached[id] != 0 && g_[id].op == operation::symbol) symbols.push(id);
    return symbols;
  }

private:
  constexpr void look_at(int id) { // and write down no more than is true: compilers are slow in it
    const node& n = g_[id];
    if (n.op == operation::symbol) return;
    const int a = n.a, b = is_binary(n.op) && !is_numbered(n.op) ? n.b : n.a;
    bool is_never_negative = false, begins = false;
    switch (form_of(n.op)) {
    case form::constant: is_never_negative = !g_.number_at(id).negative(); break;
    case form::multiply:
      is_never_negative = a == b || (is_never_negative_[a] != 0 && is_never_negative_[b] != 0);
      break;
    case form::add: is_never_negative = is_never_negative_[a] != 0 && is_never_negative_[b] != 0; break;
    case form::divide: begins = !(g_.is_constant(b) || is_sure_[b] != 0); break;
    case form::function: {
      const function_properties& f = properties_of(n.op);
      is_never_negative = f.never_negative;
      begins = !f.stays_finite;
      if (n.op == operation::sqrt) begins = is_never_negative_[a] == 0; // rounding can make it so
      break;
    }
    case form::power: begins = true; break;
    case form::symbol:
    case form::negate:
    case form::subtract:
    case form::atan2:
    case form::pair:
    case form::factorization:
    case form::solve:
    case form::transposed_solve:
    case form::component:
    case form::regularity: break;
    }
    if (is_never_negative) is_never_negative_[id] = 1;
    if (begins) begins_[id] = 1;
    any_begins_ = any_begins_ || begins;
    if (n.op == operation::constant) return;
    const bool solves = n.op >= operation::pair; // and its status is another
    if (begins || solves || may_fail_[a] != 0 || may_fail_[b] != 0) may_fail_[id] = 1;
  }

  /// Marks the operands that, not being finite, leave the result no finite number.
  static constexpr void pass_on(const node& n, sequence<char>& is_told) {
    switch (form_of(n.op)) {
    case form::add:
    case form::subtract:
    case form::multiply: is_told[n.b] = is_told[n.a] = 1; break;
    case form::divide: // 1/∞ is 0
    case form::negate: is_told[n.a] = 1; break;
    case form::function:
      if (properties_of(n.op).passes_infinity) is_told[n.a] = 1;
      break;
    case form::constant:
    case form::symbol:
    case form::power:
    case form::atan2:
    case form::pair:
    case form::factorization:
    case form::solve:
    case form::transposed_solve:
    case form::component:
    case form::regularity: break; // may be finite all the same
    }
  }

  const graph& g_;
  const sequence<int>& outputs_;
  sequence<char> live_, is_sure_, is_never_negative_, begins_, may_fail_;
  bool any_begins_ = false;
};

/// A sum as it is written: no rule lets something cancel in it.
constexpr int plain_sum(graph& g, const sequence<int>& nodes) {
  int sum = nodes[0];
  for (int i = 1; i < nodes.size(); ++i)
    sum =
        g.find_or_append({operation::add, sum < nodes[i] ? sum : nodes[i], sum < nodes[i] ? nodes[i] : sum});
  return sum;
}

/// Whether nodes rest on symbols by sines and cosines only, so that no symbol makes them large.
constexpr bool rest_on_angles_only(const graph& g, const sequence<int>& nodes) {
  sequence<char> reached(g.size(), 0);
  for (int id : nodes) reached[id] = 1;
  for (int id = g.size() - 1; id >= 0; --id) {
    const node& n = g[id];
    if (reached[id] == 0 || n.op == operation::sin || n.op == operation::cos) continue;
    if (n.op == operation::symbol) return false;
    if (is_leaf(n.op)) continue;
    reached[n.a] = 1;
    if (is_binary(n.op) && !is_numbered(n.op)) reached[n.b] = 1;
  }
  return true;
}

} // namespace kanexpr::symbolic
