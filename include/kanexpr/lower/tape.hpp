#pragma once

#include <kanexpr/symbolic/cost.hpp>

namespace kanexpr::lower {

using symbolic::graph;
using symbolic::operation;
using symbolic::sequence;

/// One step of straight-line code: slot = op(slot a, slot b).
struct instruction {
  operation op = operation::constant;
  int a = 0;
  int b = 0;
  bool paired = false; ///< a sine that brings the cosine of its angle in the next slot, or that cosine
};

/// Where the value of a slot comes from before the first step.
struct load {
  symbolic::symbol_kind from{};
  int position = 0;
};

/// Straight-line code: first the constants, then what is loaded from the arguments, then the steps, each in the slot
/// of its number. Only what the outputs need is there.
struct tape {
  sequence<instruction> steps;
  sequence<symbolic::number> numbers;
  sequence<load> loads;
  sequence<int> results; ///< slots

  constexpr int first_step() const { return numbers.size() + loads.size(); }
  constexpr int slots() const { return first_step() + steps.size(); }
};

/// Sorts the live nodes of a graph into a tape. Sine and cosine of one angle become one step, and a tangent whose
/// sine or cosine is needed anyway a division.
constexpr tape tape_of(const graph& g, const sequence<int>& outputs) {
  sequence<char> live = symbolic::live_nodes(g, outputs);
  for (int id = 0; id < g.size(); ++id) {
    if (live[id] == 0 || g[id].op != operation::tan) continue;
    const int s = g.find({operation::sin, g[id].a, 0}), c = g.find({operation::cos, g[id].a, 0});
    const bool free = s >= 0 && c >= 0 && (live[s] != 0 || live[c] != 0);
    if (free) live[s] = live[c] = 1;
  }

  tape t;
  sequence<int> slot(g.size(), -1);
  for (int id = 0; id < g.size(); ++id)
    if (live[id] != 0 && g.is_constant(id)) slot[id] = t.numbers.push(g.number_at(id));
  for (int id = 0; id < g.size(); ++id)
    if (live[id] != 0 && g[id].op == operation::symbol) {
      const symbolic::symbol& s = g.symbol_at(id);
      slot[id] = t.numbers.size() + t.loads.push({s.kind, s.position});
    }
  const int first = t.first_step();
  for (int id = 0; id < g.size(); ++id) {
    const symbolic::node& n = g[id];
    if (live[id] == 0 || is_leaf(n.op) || slot[id] >= 0) continue;
    if (n.op == operation::sin || n.op == operation::cos || n.op == operation::tan) {
      const int s = g.find({operation::sin, n.a, 0}), c = g.find({operation::cos, n.a, 0});
      if (s >= 0 && c >= 0 && live[s] != 0 && live[c] != 0) {
        if (slot[s] < 0) {
          slot[s] = first + t.steps.push({operation::sin, slot[n.a], 0, true});
          slot[c] = first + t.steps.push({operation::cos, slot[n.a], 0, true});
        }
        if (n.op == operation::tan) slot[id] = first + t.steps.push({operation::divide, slot[s], slot[c], false});
        continue;
      }
    }
    slot[id] = first + t.steps.push({n.op, slot[n.a], symbolic::is_binary(n.op) ? slot[n.b] : 0, false});
  }
  for (int id : outputs) t.results.push(slot[id]);
  return t;
}

constexpr symbolic::cost cost_of(const tape& t) {
  symbolic::cost total;
  for (const instruction& step : t.steps) {
    total.count(step.op);
    if (step.op == operation::cos && step.paired) --total.trigonometric;
  }
  return total;
}

} // namespace kanexpr::lower
