#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/base/zeros.hpp>
#include <kanexpr/lower/instruction.hpp>
#include <kanexpr/lower/step_order.hpp>
#include <kanexpr/symbolic/graph/external.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/live_nodes.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>
#include <kanexpr/symbolic/linear/expand_solves.hpp>
#include <kanexpr/symbolic/linear/symmetric_columns.hpp>

namespace kanexpr::lower {

/// Straight-line code: the constants, the arguments and the steps, whose values fill the slots in this order.
/// It contains only the nodes that the outputs need.
///
/// The sines and cosines of angles that do not depend on other functions are contiguous, `angle_count` pairs
/// starting at step `first_angle`, so that one routine can compute them all.
template <class Steps>
struct basic_tape {
  Steps steps{};
  sequence<symbolic::number> numbers{};
  sequence<load> loads{};
  sequence<int> results{}; ///< slots
  sequence<linear_step> linear_steps{};
  sequence<int> operands{}; ///< slots
  sequence<const symbolic::external_function*> externals{};
  int first_angle = 0;
  int angle_count = 0;

  constexpr int first_step() const { return numbers.size() + loads.size(); }
  constexpr int slot_count() const { return first_step() + steps.size(); }
};

using tape = basic_tape<sequence<instruction>>;

/// A tape that remains in constant evaluation.
using constant_tape = basic_tape<constant_steps>;

namespace detail {

/// Orders the live nodes of a graph. In constant evaluation, the loops access the arrays themselves
/// (base::zeros explains why).
template <bool is_constant, class Tape>
class scheduling {
public:
  constexpr scheduling(const graph& g, symbolic::live_list&& live, const sequence<int>& outputs)
      : g_(g), live_(static_cast<base::zeros<char>&&>(live.marks)), slots_(g.size()), listed_(2 * g.size()),
        outputs_(outputs) {
    list_live(live);
  }
  scheduling(const scheduling&) = delete;
  scheduling& operator=(const scheduling&) = delete;

  constexpr Tape run() {
    const auto& nodes = g_.elements<is_constant>();
    const auto& listed = listed_.elements<is_constant>();
    auto& slot = slots_.elements<is_constant>();
    if (is_constant)
      for (int id = 0; id < g_.size(); ++id) slot[id] = 0;
    sequence<int> symbols;
    for (int i = 0; i < count_; ++i) {
      const int id = listed[i];
      if (nodes[id].op > operation::symbol) continue;
      if (nodes[id].op == operation::symbol)
        symbols.push(id);
      else
        slot[id] = tape_.numbers.push(g_.number_at(id)) + 1;
    }
    for (int id : symbols) {
      const symbolic::symbol& s = g_.symbol_at(id);
      slot[id] = tape_.numbers.size() + tape_.loads.push({s.kind, s.position}) + 1;
    }
    first_step_ = tape_.first_step();
    gather_angles();
    step_order<is_constant> ordered(g_, listed_, count_, slots_, outputs_);
    const base::zeros<int>& order = ordered.run();
    put_all(order, ordered.size());
    for (int id : outputs_) tape_.results.push(slot[id] - 1);
    return static_cast<Tape&&>(tape_);
  }

private:
  static constexpr bool has_arrays = requires(Tape t) { t.steps.count; };

  /// Lists the live nodes in ascending order, including the sines and cosines from which tangents are
  /// computed.
  constexpr void list_live(const symbolic::live_list& all) {
    const auto& nodes = g_.elements<is_constant>();
    const auto& descending = all.nodes.elements<is_constant>();
    auto& listed = listed_.elements<is_constant>();
    bool adds_any = false;
    int count = 0;
    for (int i = all.count - 1; i >= 0; --i) {
      const int id = descending[i];
      listed[count++] = id;
      if (nodes[id].op == operation::tan && has_either(id))
        live_[sine_of(id)] = live_[cosine_of(id)] = 1, adds_any = true;
    }
    if (adds_any) {
      count = 0;
      for (int id = 0, end = live_.size(); id < end; ++id)
        if (live_[id] != 0) listed[count++] = id;
    }
    count_ = count;
  }

  constexpr int slot_of(int id) const { return slots_.elements<is_constant>()[id] - 1; }
  constexpr int sine_of(int id) const { return g_.find({operation::sin, g_[id].a, 0}); }
  constexpr int cosine_of(int id) const { return g_.find({operation::cos, g_[id].a, 0}); }
  static constexpr bool is_circular(operation op) {
    return op == operation::sin || op == operation::cos || op == operation::tan;
  }
  constexpr bool has_either(int id) const {
    const int s = sine_of(id), c = cosine_of(id);
    return s >= 0 && c >= 0 && (live_[s] != 0 || live_[c] != 0);
  }
  constexpr bool has_both(int id) const {
    const int s = sine_of(id), c = cosine_of(id);
    return s >= 0 && c >= 0 && live_[s] != 0 && live_[c] != 0;
  }

  /// Places angles first, then all their sines and cosines.
  constexpr void gather_angles() {
    const auto& nodes = g_.elements<is_constant>();
    const auto& listed = listed_.elements<is_constant>();
    // whether a node does not depend on any function: sums and products of arguments
    base::zeros<char> is_free(slots_.size());
    auto& free = is_free.elements<is_constant>();
    sequence<int> gathered;
    for (int i = 0; i < count_; ++i) {
      const int id = listed[i];
      const operation op = nodes[id].op;
      if (op <= operation::symbol) {
        free[id] = 1;
      } else if (op <= operation::divide) {
        if (free[nodes[id].a] != 0 && (op == operation::negate || free[nodes[id].b] != 0)) free[id] = 1;
      } else if (op == operation::sin && free[nodes[id].a] != 0 && has_both(id)) {
        put_with_operands(nodes[id].a);
        gathered.push(id);
      }
    }
    tape_.first_angle = tape_.steps.size();
    tape_.angle_count = gathered.size();
    for (int id : gathered) put(id);
  }

  constexpr void put_with_operands(int id) {
    if (slot_of(id) >= 0) return;
    put_with_operands(g_[id].a);
    if (symbolic::is_binary(g_[id].op)) put_with_operands(g_[id].b);
    put(id);
  }

  /// Assigns steps to nodes in order; most of them are operations on two slots.
  constexpr void put_all(const base::zeros<int>& in_order, int count) {
    const auto& order = in_order.elements<is_constant>();
    auto& slot = slots_.elements<is_constant>();
    if constexpr (has_arrays) { // without calls, because compilers remember each
      const auto& nodes = g_.elements<is_constant>();
      auto& steps = tape_.steps.op.template elements<true>();
      auto &a = tape_.steps.a.template elements<true>(), &b = tape_.steps.b.template elements<true>();
      int& next = tape_.steps.count;
      for (int i = 0; i < count; ++i) {
        const int id = order[i];
        if (slot[id] != 0) continue;
        const operation op = nodes[id].op;
        if (op > operation::divide) {
          put(id);
          continue;
        }
        steps[next] = op;
        a[next] = slot[nodes[id].a] - 1;
        b[next] = op == operation::negate ? 0 : slot[nodes[id].b] - 1;
        slot[id] = first_step_ + ++next;
      }
    } else {
      for (int i = 0; i < count; ++i)
        if (slot[order[i]] == 0) put(order[i]);
    }
  }

  /// Assigns a step to a node whose operands already have steps. The sine and the cosine of one angle become
  /// one step, and a tangent whose sine or cosine is needed anyway becomes a division.
  constexpr void put(int id) {
    auto& slot = slots_.elements<is_constant>();
    const symbolic::node& n = g_[id];
    if (n.op >= operation::pair) return put_solving(id, n);
    if (is_circular(n.op) && has_both(id)) {
      const int s = sine_of(id), c = cosine_of(id), angle = slot_of(n.a);
      if (slot[s] == 0) {
        slot[s] = step(operation::sin, angle, 0, true) + 1;
        slot[c] = step(operation::cos, angle, 0, true) + 1;
      }
      if (n.op == operation::tan) slot[id] = step(operation::divide, slot_of(s), slot_of(c)) + 1;
      return;
    }
    const int b = n.op != operation::negate && symbolic::is_binary(n.op) ? slot_of(n.b) : 0;
    slot[id] = step(n.op, slot_of(n.a), b) + 1;
  }

  constexpr void put_solving(int id, const symbolic::node& n) {
    if (n.op == operation::pair) return;
    if (n.op == operation::component) {
      slots_[id] = slots_[n.a] + symbolic::integer_at(g_, n.b);
      return;
    }
    if (n.op == operation::call) return put_call(id, symbolic::elements_of(g_, n.a));
    if (n.op == operation::symmetric_solve) return put_columns(id, symbolic::symmetric_columns(g_, n));
    const bool factorizes = n.op == operation::factorization;
    const linear_step added{n.op, symbolic::order_of(g_, factorizes ? id : n.a), tape_.steps.size(),
                            factorizes ? 0 : slot_of(n.a), tape_.operands.size()};
    sequence<int> inputs;
    if (factorizes)
      inputs = symbolic::entries_of(g_, id);
    else
      inputs = symbolic::elements_of(g_, n.b);
    put_linear_step(id, added, inputs);
  }

  constexpr void put_columns(int id, const symbolic::symmetric_columns& system) {
    const linear_step added{operation::symmetric_solve, system.order, tape_.steps.size(), system.columns,
                            tape_.operands.size()};
    sequence<int> inputs = system.factors;
    inputs.append(system.right);
    put_linear_step(id, added, inputs);
  }

  constexpr void put_linear_step(int id, const linear_step& added, const sequence<int>& inputs) {
    for (int input : inputs) tape_.operands.push(slot_of(input));
    tape_.linear_steps.push(added);
    slots_[id] = first_step_ + added.step + 1;
    for (int i = 0; i < added.outputs(); ++i) step(operation::component, 0, 0);
  }

  constexpr void put_call(int id, const sequence<int>& operands) {
    const symbolic::external_function* const f = &g_.external_at(id);
    int which = tape_.externals.find(f);
    if (which < 0) which = tape_.externals.push(f);
    tape_.linear_steps.push(
        {operation::call, operands.size(), tape_.steps.size(), which, tape_.operands.size()});
    for (int operand : operands) tape_.operands.push(slot_of(operand));
    slots_[id] = step(operation::component, 0, 0) + 1;
  }

  /// Adds a step and returns its slot.
  constexpr int step(operation op, int a, int b, bool is_paired = false) {
    if constexpr (has_arrays) {
      constant_steps& all = tape_.steps;
      const int i = all.count++;
      all.op.elements<is_constant>()[i] = op;
      all.a.elements<is_constant>()[i] = a;
      all.b.elements<is_constant>()[i] = b;
      if (is_paired) all.paired.elements<is_constant>()[i] = 1;
      return first_step_ + i;
    } else {
      return first_step_ + tape_.steps.push({op, a, b, is_paired});
    }
  }

  const graph& g_;
  base::zeros<char> live_;
  base::zeros<int> slots_;  ///< one more than the slot of each node
  base::zeros<int> listed_; ///< the live nodes
  const sequence<int>& outputs_;
  int count_ = 0; ///< the number of live nodes
  int first_step_ = 0;
  Tape tape_{};
};

template <bool is_constant, class Tape>
constexpr Tape tape_from(graph& g, const sequence<int>& outputs) {
  symbolic::live_list live(g, outputs);
  if (!symbolic::has_linear_systems(g, live))
    return scheduling<is_constant, Tape>(g, static_cast<symbolic::live_list&&>(live), outputs).run();
  const sequence<int> expanded = symbolic::expand_solves(g, outputs, live);
  return scheduling<is_constant, Tape>(g, symbolic::live_list(g, expanded), expanded).run();
}

} // namespace detail

/// Builds the tape that computes the outputs of a graph. Small linear systems are first expanded in the
/// graph.
constexpr tape tape_from(graph& g, const sequence<int>& outputs) {
  if (__builtin_is_constant_evaluated()) return detail::tape_from<true, tape>(g, outputs);
  return detail::tape_from<false, tape>(g, outputs);
}

/// The same, for constant evaluation only.
constexpr constant_tape constant_tape_from(graph& g, const sequence<int>& outputs) {
  return detail::tape_from<true, constant_tape>(g, outputs);
}

/// Builds the tape without changing the graph.
constexpr tape tape_of(const graph& g, const sequence<int>& outputs) {
  graph own = g;
  return tape_from(own, outputs);
}

} // namespace kanexpr::lower
