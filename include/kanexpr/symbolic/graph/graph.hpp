#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>
#include <kanexpr/symbolic/numbers/number.hpp>

#include <bit>

namespace kanexpr::symbolic {

/// One operation; its operands are the numbers of earlier nodes.
///
/// A constant's `a` is its place among the numbers, a symbol's its place among the symbols.
struct node {
  operation op = operation::constant;
  int a = 0;
  int b = 0;
};

/// A hash-consed expression graph: equal expressions are one node, operands come before their users.
///
/// This class only stores. What may be built, and in which simplest form, is in rules.hpp.
class graph {
public:
  static constexpr int zero = 0;
  static constexpr int one = 1;

  constexpr graph() {
    table_.resize(1 << 10, -1);
    constant(exactly(0));
    constant(exactly(1));
  }

  constexpr int size() const { return nodes_.size(); }
  /// Whether there is anything of a linear system, live or not.
  constexpr bool holds_lists() const { return holds_lists_; }
  constexpr const node& operator[](int id) const { return nodes_[id]; }
  constexpr const node* begin() const { return nodes_.begin(); }
  constexpr const node* end() const { return nodes_.end(); }

  constexpr bool is_constant(int id) const { return nodes_[id].op == operation::constant; }
  constexpr const number& number_at(int id) const { return numbers_[nodes_[id].a]; }
  constexpr const symbol& symbol_at(int id) const { return symbols_[nodes_[id].a]; }
  constexpr const sequence<symbol>& symbols() const { return symbols_; }
  constexpr const sequence<number>& numbers() const { return numbers_; }

  constexpr int constant(const number& value) {
    const int place = slot(place_of(value));
    if (table_[place] >= 0) return table_[place];
    table_[place] = nodes_.size();
    return append({operation::constant, numbers_.push(value), 0});
  }

  /// The node of an existing constant, or -1.
  constexpr int find_constant(const number& value) const { return table_[slot(place_of(value))]; }

  /// The node of a symbol; two symbols are the same where kind and name are.
  constexpr int variable(const symbol& wanted) {
    for (int i = 0; i < symbols_.size(); ++i)
      if (symbols_[i] == wanted) return find_or_append({operation::symbol, i, 0});
    return find_or_append({operation::symbol, symbols_.push(wanted), 0});
  }

  /// Number of an existing node, or -1.
  constexpr int find(const node& wanted) const { return table_[slot(place_of(wanted))]; }

  constexpr int find_or_append(const node& wanted) {
    const int place = slot(place_of(wanted));
    if (table_[place] >= 0) return table_[place];
    table_[place] = nodes_.size();
    return append(wanted);
  }

  /// Begins anew, with the numbers and symbols of a graph of which the nodes follow by `restore`.
  constexpr void restart(sequence<number>&& numbers, sequence<symbol>&& symbols, int nodes) {
    numbers_ = static_cast<sequence<number>&&>(numbers);
    symbols_ = static_cast<sequence<symbol>&&>(symbols);
    nodes_.clear();
    nodes_.reserve(nodes);
    int places = table_.size();
    while (2 * nodes > places) places *= 4;
    table_ = sequence<int>(places, -1);
  }
  /// A node in the order in which they stood in a graph.
  constexpr void restore(const node& kept) {
    table_[free_place(kept)] = nodes_.push(kept);
    if (kept.op >= operation::pair) holds_lists_ = true;
  }

private:
  static constexpr unsigned hash(const number& value) {
    const std::uint64_t fraction =
        static_cast<std::uint64_t>(value.numerator) * 31 + static_cast<std::uint64_t>(value.denominator);
    const auto real = std::bit_cast<std::uint64_t>(value.real);
    return hash(operation::constant, static_cast<int>(fraction), static_cast<int>(real ^ (real >> 32)));
  }
  static constexpr unsigned hash(operation op, int a, int b) {
    const unsigned mixed = (static_cast<unsigned>(a) * 2654435761u) ^
                           (static_cast<unsigned>(b) * 2246822519u) ^
                           (static_cast<unsigned>(op) * 3266489917u);
    return mixed ^ (mixed >> 15);
  }
  constexpr int slot(unsigned place) const {
    return static_cast<int>(place & (static_cast<unsigned>(table_.size()) - 1));
  }
  constexpr unsigned place_of(const number& wanted) const {
    unsigned place = hash(wanted);
    for (; table_[slot(place)] >= 0; ++place) {
      const int id = table_[slot(place)];
      if (nodes_[id].op == operation::constant && number_at(id) == wanted) break;
    }
    return place;
  }
  constexpr unsigned place_of(const node& wanted) const {
    unsigned place = hash(wanted.op, wanted.a, wanted.b);
    for (; table_[slot(place)] >= 0; ++place) {
      const node& present = nodes_[table_[slot(place)]];
      if (present.a == wanted.a && present.b == wanted.b && present.op == wanted.op) break;
    }
    return place;
  }
  constexpr int append(const node& added) {
    const int id = nodes_.push(added);
    if (added.op >= operation::pair) holds_lists_ = true;
    if (2 * nodes_.size() > table_.size()) rehash();
    return id;
  }
  constexpr void rehash() {
    table_ = sequence<int>(4 * table_.size(), -1);
    for (int id = 0; id < nodes_.size(); ++id) table_[free_place(nodes_[id])] = id;
  }
  /// Where in the table a node goes that is not there yet.
  constexpr int free_place(const node& added) const {
    unsigned place =
        added.op == operation::constant ? hash(numbers_[added.a]) : hash(added.op, added.a, added.b);
    while (table_[slot(place)] >= 0) ++place;
    return slot(place);
  }

  sequence<node> nodes_{};
  sequence<number> numbers_{};
  sequence<symbol> symbols_{};
  sequence<int> table_{}; ///< open addressing; -1 is free
  bool holds_lists_ = false;
};

} // namespace kanexpr::symbolic
