#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>
#include <kanexpr/symbolic/numbers/number.hpp>

#include <bit>

namespace kanexpr::symbolic {

/// One operation; its operands are the numbers of earlier nodes.
///
/// A constant's `a` is its place among the numbers, a symbol's its place among the symbols. Without
/// initializers, which the compiler would run for each node that there is room for.
struct node {
  operation op;
  int a;
  int b;
};

/// A hash-consed expression graph: equal expressions are one node, operands come before their users.
///
/// This class only stores. What may be built, and in which simplest form, is in rules.hpp. It is what a
/// derivation does most, and compilers interpret every call; so it looks into its arrays directly.
class graph {
public:
  static constexpr int zero = 0;
  static constexpr int one = 1;

  constexpr graph() {
    make_table(1 << 10);
    constant(exactly(0));
    constant(exactly(1));
  }
  constexpr graph(const graph& other)
      : nodes_(other.nodes_), numbers_(other.numbers_), symbols_(other.symbols_), table_(other.table_),
        first_(nodes_.begin()), last_place_(other.last_place_), holds_lists_(other.holds_lists_) {}
  graph& operator=(const graph&) = delete;

  constexpr int size() const { return nodes_.size(); }
  /// Whether there is anything of a linear system, live or not.
  constexpr bool holds_lists() const { return holds_lists_; }
  constexpr const node& operator[](int id) const { return first_[id]; }
  constexpr const node* begin() const { return first_; }
  constexpr const node* end() const { return nodes_.end(); }

  constexpr bool is_constant(int id) const { return first_[id].op == operation::constant; }
  constexpr const number& number_at(int id) const { return numbers_[first_[id].a]; }
  constexpr const symbol& symbol_at(int id) const { return symbols_[first_[id].a]; }
  constexpr const sequence<symbol>& symbols() const { return symbols_; }
  constexpr const sequence<number>& numbers() const { return numbers_; }

  constexpr int constant(const number& value) {
    int& entry = table_[place_of(value)];
    if (entry >= 0) return entry;
    entry = nodes_.size();
    return append({operation::constant, numbers_.push(value), 0});
  }

  /// The node of an existing constant, or -1.
  constexpr int find_constant(const number& value) const { return table_[place_of(value)]; }

  /// The node of a symbol; two symbols are the same where kind and name are.
  constexpr int variable(const symbol& wanted) {
    const symbol* const all = symbols_.begin();
    for (int i = 0, end = symbols_.size(); i < end; ++i)
      if (all[i].kind == wanted.kind && all[i].called.length == wanted.called.length && all[i] == wanted)
        return find_or_append({operation::symbol, i, 0});
    return find_or_append({operation::symbol, symbols_.push(wanted), 0});
  }

  /// Number of an existing node, or -1.
  constexpr int find(const node& wanted) const { return table_[place_of(wanted)]; }

  constexpr int find_or_append(const node& wanted) {
    int& entry = table_[place_of(wanted)];
    if (entry >= 0) return entry;
    entry = nodes_.size();
    return append(wanted);
  }

  /// Begins anew, with the numbers and symbols of a graph of which the nodes follow by `restore`.
  constexpr void restart(sequence<number>&& numbers, sequence<symbol>&& symbols, int nodes) {
    numbers_ = static_cast<sequence<number>&&>(numbers);
    symbols_ = static_cast<sequence<symbol>&&>(symbols);
    nodes_.clear();
    nodes_.reserve(nodes);
    first_ = nodes_.begin();
    int places = 1 << 10;
    while (2 * nodes > places) places *= 4;
    make_table(places);
  }
  /// A node in the order in which they stood in a graph.
  constexpr void restore(const node& kept) {
    enter(kept, nodes_.push(kept));
    if (kept.op >= operation::pair) holds_lists_ = true;
  }

private:
  static constexpr unsigned hash(const number& value) {
    const std::uint64_t fraction =
        static_cast<std::uint64_t>(value.numerator) * 31 + static_cast<std::uint64_t>(value.denominator);
    const auto real = std::bit_cast<std::uint64_t>(value.real);
    return hash({operation::constant, static_cast<int>(fraction), static_cast<int>(real ^ (real >> 32))});
  }
  static constexpr unsigned hash(const node& n) {
    const unsigned mixed = (static_cast<unsigned>(n.a) * 2654435761u) ^
                           (static_cast<unsigned>(n.b) * 2246822519u) ^
                           (static_cast<unsigned>(n.op) * 3266489917u);
    return mixed ^ (mixed >> 15);
  }

  /// Where in the table something stands, or would.
  constexpr int place_of(const number& wanted) const {
    const int* const table = table_.begin();
    unsigned place = hash(wanted) & last_place_;
    for (; table[place] >= 0; place = (place + 1) & last_place_) {
      const node& present = first_[table[place]];
      if (present.op == operation::constant && numbers_[present.a] == wanted) break;
    }
    return static_cast<int>(place);
  }
  constexpr int place_of(const node& wanted) const {
    const int* const table = table_.begin();
    unsigned place = hash(wanted) & last_place_;
    for (; table[place] >= 0; place = (place + 1) & last_place_) {
      const node& present = first_[table[place]];
      if (present.a == wanted.a && present.b == wanted.b && present.op == wanted.op) break;
    }
    return static_cast<int>(place);
  }
  constexpr int append(const node& added) {
    const int id = nodes_.push(added);
    first_ = nodes_.begin();
    if (added.op >= operation::pair) holds_lists_ = true;
    if (2u * static_cast<unsigned>(id) >= last_place_) rehash();
    return id;
  }
  constexpr void rehash() {
    make_table(4 * table_.size());
    for (int id = 0, end = nodes_.size(); id < end; ++id) enter(first_[id], id);
  }
  constexpr void make_table(int places) {
    table_ = sequence<int>(places, -1);
    last_place_ = static_cast<unsigned>(places) - 1;
  }
  /// Of a node that is not in the table yet.
  constexpr void enter(const node& added, int id) {
    int* const table = table_.begin();
    unsigned place = (added.op == operation::constant ? hash(numbers_[added.a]) : hash(added)) & last_place_;
    while (table[place] >= 0) place = (place + 1) & last_place_;
    table[place] = id;
  }

  sequence<node> nodes_{};
  sequence<number> numbers_{};
  sequence<symbol> symbols_{};
  sequence<int> table_{}; ///< open addressing; -1 is free
  const node* first_ = nullptr;
  unsigned last_place_ = 0; ///< of the table, whose size is a power of 2
  bool holds_lists_ = false;
};

} // namespace kanexpr::symbolic
