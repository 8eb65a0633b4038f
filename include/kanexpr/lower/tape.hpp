#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/base/zeros.hpp>
#include <kanexpr/lower/step_order.hpp>
#include <kanexpr/numeric/elimination.hpp>
#include <kanexpr/numeric/symmetric_columns.hpp>
#include <kanexpr/symbolic/cost.hpp>
#include <kanexpr/symbolic/graph/external.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>
#include <kanexpr/symbolic/linear/symmetric_columns.hpp>

namespace kanexpr::lower {

/// One step of straight-line code: slot = op(slot a, slot b).
struct instruction {
  operation op;
  int a;
  int b;
  bool paired; ///< a sine followed by the cosine of its angle in the next slot, or that cosine
};

/// A step that fills several slots, either part of the solution of a linear system or a function call.
/// Starting at `step`, it fills as many slots as its operation requires; the list of steps marks them as its
/// components.
struct linear_step {
  operation op = operation::factorization;
  int order = 0; ///< for a call: the number of operands
  int step = 0;
  int factors = 0;  ///< the first slot of the factorization that it uses; for a call: the index of the
                    ///< function; for a symmetric system: the number of columns
  int operands = 0; ///< the index of its first operand among those of all linear steps

  constexpr int inputs() const {
    if (op == operation::symmetric_solve) return numeric::symmetric_factors{order}.size() + order * factors;
    return op == operation::factorization || op == operation::singularity_measure ? order * order : order;
  }
  constexpr int outputs() const {
    if (op == operation::symmetric_solve) return order * factors;
    if (op == operation::factorization) return numeric::factors{order}.size();
    return op == operation::singularity_measure || op == operation::call ? 1 : order;
  }
};

/// The source of the value of a slot that is filled before the first step.
struct load {
  symbolic::symbol_kind from{};
  int position = 0;
};

/// Straight-line code: the constants, the arguments and the steps, whose values fill the slots in this order.
/// It contains only the nodes that the outputs need.
///
/// The sines and cosines of angles that do not depend on other functions are contiguous, `angle_count` pairs
/// starting at step `first_angle`, so that one routine can compute them all.
struct tape {
  sequence<instruction> steps{};
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

namespace detail {

/// Orders the live nodes of a graph. The code accesses arrays directly because compilers interpret every
/// call.
class scheduling {
public:
  constexpr scheduling(const graph& g, sequence<char>&& live, const sequence<int>& outputs)
      : g_(g), live_(static_cast<sequence<char>&&>(live)), slots_(g.size(), none), outputs_(outputs),
        nodes_(g.begin()), is_live_(live_.begin()), slot_(slots_.begin()) {
    list_live(g.size());
  }
  scheduling(const scheduling&) = delete;
  scheduling& operator=(const scheduling&) = delete;

  constexpr tape run() {
    sequence<int> symbols;
    for (int id : nodes_in_order_) {
      if (nodes_[id].op > operation::symbol) continue;
      if (nodes_[id].op == operation::symbol)
        symbols.push(id);
      else
        slot_[id] = tape_.numbers.push(g_.number_at(id));
    }
    for (int id : symbols) {
      const symbolic::symbol& s = g_.symbol_at(id);
      slot_[id] = tape_.numbers.size() + tape_.loads.push({s.kind, s.position});
    }
    first_step_ = tape_.first_step();
    tape_.steps.reserve(nodes_in_order_.size());
    gather_angles();
    const sequence<int> order = step_order(g_, nodes_in_order_, slots_, outputs_).run();
    for (int id : order)
      if (slot_[id] == none) put(id);
    for (int id : outputs_) tape_.results.push(slot_[id]);
    return static_cast<tape&&>(tape_);
  }

private:
  static constexpr int none = -1;

  /// Lists the live nodes, including the sines and cosines from which tangents are computed.
  constexpr void list_live(int end) {
    int count = 0;
    for (int id = 0; id < end; ++id) {
      if (is_live_[id] == 0) continue;
      ++count;
      if (nodes_[id].op != operation::tan || !has_either(id)) continue;
      for (int part : {sine_of(id), cosine_of(id)}) {
        if (is_live_[part] == 0 && part < id) ++count; // the others are encountered later
        is_live_[part] = 1;
      }
    }
    nodes_in_order_.resize(count);
    int* next = nodes_in_order_.begin();
    for (int id = 0; id < end; ++id)
      if (is_live_[id] != 0) *next++ = id;
  }

  constexpr int sine_of(int id) const { return g_.find({operation::sin, nodes_[id].a, 0}); }
  constexpr int cosine_of(int id) const { return g_.find({operation::cos, nodes_[id].a, 0}); }
  static constexpr bool is_circular(operation op) {
    return op == operation::sin || op == operation::cos || op == operation::tan;
  }
  constexpr bool has_either(int id) const {
    const int s = sine_of(id), c = cosine_of(id);
    return s >= 0 && c >= 0 && (is_live_[s] != 0 || is_live_[c] != 0);
  }
  constexpr bool has_both(int id) const {
    const int s = sine_of(id), c = cosine_of(id);
    return s >= 0 && c >= 0 && is_live_[s] != 0 && is_live_[c] != 0;
  }

  /// Places angles first, then all their sines and cosines.
  constexpr void gather_angles() {
    // whether a node does not depend on any function: sums and products of arguments
    base::zeros<char> is_free(slots_.size());
    char* const free = is_free.begin();
    sequence<int> gathered;
    for (int id : nodes_in_order_) {
      const symbolic::node& n = nodes_[id];
      if (n.op <= operation::symbol)
        free[id] = 1;
      else if (n.op <= operation::divide)
        free[id] = free[n.a] != 0 && (n.op == operation::negate || free[n.b] != 0);
      else if (n.op == operation::sin && free[n.a] != 0 && has_both(id)) {
        put_with_operands(n.a);
        gathered.push(id);
      }
    }
    tape_.first_angle = tape_.steps.size();
    tape_.angle_count = gathered.size();
    for (int id : gathered) put(id);
  }

  constexpr void put_with_operands(int id) {
    if (slot_[id] != none) return;
    put_with_operands(nodes_[id].a);
    if (symbolic::is_binary(nodes_[id].op)) put_with_operands(nodes_[id].b);
    put(id);
  }

  /// Assigns a step to a node whose operands already have steps. The sine and the cosine of one angle become
  /// one step, and a tangent whose sine or cosine is needed anyway becomes a division.
  constexpr void put(int id) {
    const symbolic::node& n = nodes_[id];
    if (n.op <= operation::divide) {
      const int b = n.op == operation::negate ? 0 : slot_[n.b];
      slot_[id] = first_step_ + tape_.steps.push({n.op, slot_[n.a], b, false});
      return;
    }
    if (n.op >= operation::pair) return put_solving(id, n);
    if (is_circular(n.op) && has_both(id)) {
      const int s = sine_of(id), c = cosine_of(id);
      if (slot_[s] == none) {
        slot_[s] = step({operation::sin, slot_[n.a], 0, true});
        slot_[c] = step({operation::cos, slot_[n.a], 0, true});
      }
      if (n.op == operation::tan) slot_[id] = step({operation::divide, slot_[s], slot_[c], false});
      return;
    }
    const int b = symbolic::is_binary(n.op) ? slot_[n.b] : 0;
    slot_[id] = step({n.op, slot_[n.a], b, false});
  }

  constexpr void put_solving(int id, const symbolic::node& n) {
    if (n.op == operation::pair) return;
    if (n.op == operation::component) {
      slot_[id] = slot_[n.a] + symbolic::integer_at(g_, n.b);
      return;
    }
    if (n.op == operation::call) return put_call(id, symbolic::elements_of(g_, n.a));
    if (n.op == operation::symmetric_solve) return put_columns(id, symbolic::symmetric_columns(g_, n));
    const bool factorizes = n.op == operation::factorization;
    const linear_step added{n.op, symbolic::order_of(g_, factorizes ? id : n.a), tape_.steps.size(),
                            factorizes ? 0 : slot_[n.a], tape_.operands.size()};
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
    for (int input : inputs) tape_.operands.push(slot_[input]);
    tape_.linear_steps.push(added);
    slot_[id] = first_step_ + added.step;
    for (int i = 0; i < added.outputs(); ++i) step({operation::component, 0, 0, false});
  }

  constexpr void put_call(int id, const sequence<int>& operands) {
    const symbolic::external_function* const f = &g_.external_at(id);
    int which = tape_.externals.find(f);
    if (which < 0) which = tape_.externals.push(f);
    tape_.linear_steps.push(
        {operation::call, operands.size(), tape_.steps.size(), which, tape_.operands.size()});
    for (int operand : operands) tape_.operands.push(slot_[operand]);
    slot_[id] = step({operation::component, 0, 0, false});
  }

  constexpr int step(const instruction& added) { return first_step_ + tape_.steps.push(added); }

  const graph& g_;
  sequence<char> live_;
  sequence<int> slots_;
  const sequence<int>& outputs_;
  const symbolic::node* nodes_;
  char* is_live_;
  int* slot_;                      ///< the slot of each node
  sequence<int> nodes_in_order_{}; ///< the live nodes
  int first_step_ = 0;
  tape tape_{};
};

} // namespace detail

/// Builds the tape that computes the outputs of a graph. Small linear systems are first expanded in the
/// graph.
constexpr tape tape_from(graph& g, const sequence<int>& outputs) {
  sequence<char> live = symbolic::live_nodes(g, outputs);
  if (!symbolic::has_linear_systems(g, live))
    return detail::scheduling(g, static_cast<sequence<char>&&>(live), outputs).run();
  const sequence<int> expanded = symbolic::expand_solves(g, outputs);
  return detail::scheduling(g, symbolic::live_nodes(g, expanded), expanded).run();
}

/// Builds the tape without changing the graph.
constexpr tape tape_of(const graph& g, const sequence<int>& outputs) {
  graph own = g;
  return tape_from(own, outputs);
}

namespace detail {

/// The number of sums that can be evaluated together with a product that nothing else uses. The code calls no
/// functions, because compilers interpret and remember every call.
constexpr int fused_sums(const tape& t) {
  constexpr operation add = operation::add, subtract = operation::subtract, multiply = operation::multiply;
  sequence<int> all_uses(t.slot_count(), 0);
  int* const uses = all_uses.begin();
  const instruction *const steps = t.steps.begin(), *const end = t.steps.end();
  for (const instruction* s = steps; s != end; ++s) {
    if (s->op >= operation::component) continue; // its operands are listed
    ++uses[s->a];
    ++uses[s->b]; // the slot of a number or an argument for operations with one operand
  }
  for (int slot : t.operands) ++uses[slot];
  for (int slot : t.results) ++uses[slot];
  const int first = t.first_step();
  int fused = 0;
  for (const instruction* s = steps; s != end; ++s) {
    if (s->op != add && s->op != subtract) continue;
    const int a = s->a, b = s->b;
    if ((a >= first && uses[a] == 1 && steps[a - first].op == multiply) ||
        (b >= first && uses[b] == 1 && steps[b - first].op == multiply))
      ++fused;
  }
  return fused;
}

} // namespace detail

/// The slot of the number zero; -1 if a tape has none.
template <class Code>
constexpr int slot_of_zero(const Code& code) {
  for (int i = 0; i < code.numbers.size(); ++i)
    if (code.numbers[i].is_zero()) return i;
  return -1;
}

/// The steps of a symmetric system for each column.
template <class Code>
constexpr numeric::column_steps column_steps_of(const Code& code, const linear_step& e) {
  const int zero = slot_of_zero(code), columns = e.factors,
            right = e.operands + numeric::symmetric_factors{e.order}.size();
  return {e.order, [&](int factor) { return code.operands[e.operands + factor] == zero; },
          [&](int row) {
            for (int j = 0; j < columns; ++j)
              if (code.operands[right + row * columns + j] != zero) return false;
            return true;
          }};
}

/// Returns the cost of one evaluation of a tape.
constexpr symbolic::cost cost_of(const tape& t) {
  symbolic::cost total;
  for (const linear_step& e : t.linear_steps) {
    if (e.op == operation::factorization)
      total.count_factorization(e.order);
    else if (e.op == operation::singularity_measure)
      total.count_singularity_measure(e.order);
    else if (e.op == operation::call)
      total.count(operation::call);
    else if (e.op == operation::symmetric_solve)
      total.count_columns(column_steps_of(t, e), e.factors);
    else
      total.count_substitution(e.order);
  }
  int times[static_cast<int>(operation::singularity_measure) + 1]{}; // the number of steps of each operation
  for (const instruction& step : t.steps) {
    ++times[static_cast<int>(step.op)];
    if (step.op == operation::cos && step.paired) --total.trigonometric;
  }
  for (int op = 0; op < static_cast<int>(operation::component); ++op)
    total.count(static_cast<operation>(op), times[op]);
  total.fused += detail::fused_sums(t);
  return total;
}

} // namespace kanexpr::lower
