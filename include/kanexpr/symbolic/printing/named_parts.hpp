#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/external.hpp>
#include <kanexpr/symbolic/graph/function_table.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/live_nodes.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>
#include <kanexpr/symbolic/numbers/decimal_text.hpp>

#include <algorithm>
#include <string>
#include <string_view>

namespace kanexpr::symbolic::printing {

/// The parts of expressions that a text defines once and then refers to by name: those that occur more than
/// once and whose text is longer than `shortest_shared`, and all whose text would be longer than `longest`.
/// The length of the whole text is therefore proportional to the number of nodes. Lengths are those of plain
/// text, counted from the operands upwards, with names in place of the parts that have one.
class named_parts {
public:
  static constexpr int shortest_shared = 20, longest = 400;

  named_parts(const graph& g, const sequence<int>& outputs) : numbers_(g.size(), no_part) {
    while (is_taken(g)) letters_ += letters_[0];
    choose(g, outputs);
  }

  bool has(int id) const { return numbers_[id] != no_part; }
  void number(int id, int number) { numbers_[id] = number; }
  std::string name(int id) const { return letters_ + std::to_string(numbers_[id]); }

private:
  static constexpr int no_part = -1, length_of_name = 3;

  void choose(const graph& g, const sequence<int>& outputs) {
    const base::zeros<char> live = live_nodes(g, outputs);
    const sequence<char> is_shared = shared_nodes(g, outputs, live);
    sequence<int> lengths(g.size(), 0); // of the text that refers to a node
    for (int id = 0; id < g.size(); ++id) {
      if (live[id] == 0) continue;
      const node& n = g[id];
      lengths[id] = own_length(g, id);
      if (is_leaf(n.op)) continue;
      lengths[id] += lengths[n.a];
      if (is_binary(n.op) && is_value(n)) lengths[id] += lengths[n.b];
      if (n.op == operation::pair) continue;
      if (lengths[id] <= (is_shared[id] != 0 ? shortest_shared : longest)) continue;
      numbers_[id] = 0;
      lengths[id] = length_of_name;
    }
  }

  /// Marks the nodes with more than one user. A list is written wherever it occurs, so its elements have as
  /// many users as the list.
  static sequence<char> shared_nodes(const graph& g, const sequence<int>& outputs,
                                     const base::zeros<char>& live) {
    sequence<char> users(g.size(), 0); // at most 2 are counted
    const auto add = [&users](int id, int count) {
      users[id] = static_cast<char>((std::min)(users[id] + count, 2));
    };
    for (int id : outputs) add(id, 1);
    for (int id = g.size() - 1; id >= 0; --id) {
      const node& n = g[id];
      if (live[id] == 0 || is_leaf(n.op)) continue;
      const int times = n.op == operation::pair ? users[id] : 1;
      add(n.a, times);
      if (is_binary(n.op) && is_value(n) && n.b != n.a) add(n.b, times);
    }
    for (char& each : users) each = each > 1 ? 1 : 0;
    return users;
  }

  /// The characters of a node without its operands.
  static int own_length(const graph& g, int id) {
    const operation op = g[id].op;
    if (op == operation::symbol) return g.symbol_at(id).called.length;
    if (op == operation::constant) return static_cast<int>(decimal_text(g.number_at(id)).view().size());
    constexpr int length_of_operator = 3;
    return length_of_operator + static_cast<int>(std::string_view(function_name(op)).size());
  }

  /// Whether a symbol or a function has a name that could also be the name of a part, or is typeset like it.
  bool is_taken(const graph& g) const {
    for (const symbol& s : g.symbols())
      if (is_like_a_name(s.called.view())) return true;
    for (const external_function* f : g.externals())
      if (is_like_a_name(f->called.view())) return true;
    return false;
  }
  bool is_like_a_name(std::string_view called) const {
    if (!called.starts_with(letters_)) return false;
    called.remove_prefix(letters_.size());
    while (called.starts_with('_')) called.remove_prefix(1);
    return !called.empty() && called[0] >= '0' && called[0] <= '9';
  }

  std::string letters_ = "z";
  sequence<int> numbers_; ///< by node
};

} // namespace kanexpr::symbolic::printing
