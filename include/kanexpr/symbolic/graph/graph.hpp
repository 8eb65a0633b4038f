#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/base/zeros.hpp>
#include <kanexpr/symbolic/graph/external.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>
#include <kanexpr/symbolic/numbers/number.hpp>

#include <bit>
#include <utility>

namespace kanexpr::symbolic {

using base::sequence;

/// One operation; its operands are the numbers of earlier nodes.
///
/// For a constant, `a` is its index among the numbers; for a symbol, its index among the symbols. No default
/// initializers: the compiler would run them for every element of the array.
struct node {
  operation op;
  int a;
  int b;
};

/// A hash-consed expression graph: equal expressions share one node, and operands precede their users.
///
/// This class only stores nodes; rules.hpp builds them in simplest form. Most of the work of a derivation is
/// done here, and compilers interpret every call, so the code accesses its arrays directly.
class graph {
  // the most frequent rules (rules.hpp), which read the nodes
  friend constexpr int negate(graph& g, int a);
  friend constexpr int add(graph& g, int a, int b);
  friend constexpr int subtract(graph& g, int a, int b);
  friend constexpr int multiply(graph& g, int a, int b);
  friend constexpr int divide(graph& g, int a, int b);

  // precedes its callers, because clang++ does not instantiate a template for a constant expression if it is
  // declared later in the class
  template <class Nodes, class From>
  static constexpr void copy(Nodes& nodes, const From& all, int count) {
    for (int id = 0; id < count; ++id) {
      nodes[id].op = all[id].op;
      nodes[id].a = all[id].a;
      nodes[id].b = all[id].b;
    }
  }

  template <class Nodes, class Table>
  constexpr void index_nodes(const Nodes& nodes, Table& table, int count) {
    const unsigned mask = hash_mask_;
    for (int id = 0; id < count; ++id) {
      const operation op = nodes[id].op;
      unsigned place = 0;
      if (op == operation::constant)
        place = hash(numbers_[nodes[id].a]) & mask;
      else if (__builtin_is_constant_evaluated())
        place = static_cast<unsigned>(nodes[id].a * 211 + nodes[id].b * 5 + static_cast<int>(op)) & mask;
      else
        place = hash(nodes[id]) & mask;
      while (table[place] != 0) place = (place + 1) & mask;
      table[place] = id + 1;
      if (op >= operation::pair) has_lists_ = true;
    }
  }

public:
  static constexpr int zero = 0;
  static constexpr int one = 1;

  constexpr graph() {
    allocate(least_room);
    constant(exactly(0));
    constant(exactly(1));
  }
  constexpr graph(const graph& other)
      : numbers_(other.numbers_), symbols_(other.symbols_), externals_(other.externals_),
        has_lists_(other.has_lists_) {
    allocate(other.room_);
    if (__builtin_is_constant_evaluated())
      copy(block_->value, other.block_->value, other.size_);
    else
      copy(nodes_, other.nodes_, other.size_);
    index_nodes(other.size_);
  }
  graph& operator=(const graph&) = delete;
  constexpr ~graph() { release(); }

  constexpr int size() const { return size_; }
  /// Whether the graph contains any part of a linear system or a call, live or not.
  constexpr bool has_lists() const { return has_lists_; }
  constexpr const node& operator[](int id) const { return nodes_[id]; }
  /// A copy of a node, which takes less memory in constant evaluation than reading it through a reference.
  constexpr node node_at(int id) const {
    return __builtin_is_constant_evaluated() ? block_->value[id] : nodes_[id];
  }
  constexpr const node* begin() const { return nodes_; }
  constexpr const node* end() const { return nodes_ + size_; }
  /// The nodes for the most frequent loops: in constant evaluation the array itself (base::zeros explains
  /// why), at run time a pointer to it.
  template <bool is_constant>
  constexpr const auto& elements() const {
    if constexpr (is_constant)
      return block_->value;
    else
      return nodes_;
  }

  constexpr bool is_constant(int id) const { return nodes_[id].op == operation::constant; }
  constexpr const number& number_at(int id) const { return numbers_[nodes_[id].a]; }
  constexpr const symbol& symbol_at(int id) const { return symbols_[nodes_[id].a]; }
  constexpr const sequence<symbol>& symbols() const { return symbols_; }
  constexpr const sequence<number>& numbers() const { return numbers_; }

  /// Records that the program put the integer 0 into an expression; `consume_integer_zero` reports this once.
  void record_integer_zero() { has_integer_zero_ = true; }
  bool consume_integer_zero() { return std::exchange(has_integer_zero_, false); }

  /// Records a clamp whose lower bound exceeds its upper bound.
  void record_reversed_bounds() { has_reversed_bounds_ = true; }
  bool consume_reversed_bounds() { return std::exchange(has_reversed_bounds_, false); }

  /// The user-defined functions called in this graph.
  constexpr sequence<const external_function*>& externals() { return externals_; }
  constexpr const sequence<const external_function*>& externals() const { return externals_; }
  /// The function of a call.
  constexpr const external_function& external_at(int id) const {
    return *externals_[static_cast<int>(number_at(nodes_[id].b).numerator)];
  }

  constexpr int constant(const number& value) {
    const int place = place_of(value);
    if (table_[place] != 0) return table_[place] - 1;
    return append({operation::constant, numbers_.push(value), 0}, place);
  }

  /// The node of a constant, or -1 if there is none.
  constexpr int find_constant(const number& value) const { return table_[place_of(value)] - 1; }

  /// The node of a symbol; symbols are equal if their kinds and names are equal.
  constexpr int variable(const symbol& wanted) {
    const symbol* const all = symbols_.begin();
    const int length = wanted.called.length, last = length > 0 ? length - 1 : 0; // where most names differ
    for (int i = 0, end = symbols_.size(); i < end; ++i)
      if (all[i].called.length == length && all[i].called.letters[last] == wanted.called.letters[last] &&
          all[i] == wanted)
        return find_or_append({operation::symbol, i, 0});
    return find_or_append({operation::symbol, symbols_.push(wanted), 0});
  }

  /// The number of an existing node, or -1 if there is none.
  constexpr int find(const node& wanted) const { return find(wanted.op, wanted.a, wanted.b); }
  constexpr int find(operation op, int a, int b) const {
    if (!__builtin_is_constant_evaluated()) return find_at_run_time({op, a, b});
    const unsigned mask = hash_mask_;
    const auto& nodes = block_->value;
    const auto& table = slots_->value;
    unsigned place = mask & static_cast<unsigned>(a * 211 + b * 5 + static_cast<int>(op));
    for (int next = table[place]; next != 0; next = table[place = (place + 1) & mask])
      if (nodes[next - 1].a == a && nodes[next - 1].b == b && nodes[next - 1].op == op) return next - 1;
    return -1;
  }

  constexpr int find_or_append(const node& wanted) { return find_or_append(wanted.op, wanted.a, wanted.b); }
  /// The most frequent function of all; in constant evaluation, a node as its argument would take memory.
  constexpr int find_or_append(operation op, int a, int b) {
    if (!__builtin_is_constant_evaluated()) return find_or_append_at_run_time({op, a, b});
    const unsigned mask = hash_mask_;
    auto& nodes = block_->value;
    auto& table = slots_->value;
    unsigned place = mask & static_cast<unsigned>(a * 211 + b * 5 + static_cast<int>(op));
    for (int next = table[place]; next != 0; next = table[place = (place + 1) & mask])
      if (nodes[next - 1].a == a && nodes[next - 1].b == b && nodes[next - 1].op == op) return next - 1;
    const int id = size_;
    if (id == room_ || op >= operation::pair) return append({op, a, b}, static_cast<int>(place));
    nodes[id].op = op;
    nodes[id].a = a;
    nodes[id].b = b;
    size_ = table[place] = id + 1;
    return id;
  }

  /// What a graph contains at some time.
  struct extent {
    int nodes, numbers, symbols, externals;
    bool has_lists;
  };
  constexpr extent present() const {
    return {size_, numbers_.size(), symbols_.size(), externals_.size(), has_lists_};
  }
  /// Discards everything that was added since; no expression may refer to it any more.
  constexpr void forget_after(const extent& kept) {
    for (; size_ > kept.nodes; --size_) { // the last node first, so that the slots of all others stay valid
      const node& last = nodes_[size_ - 1];
      unsigned place = (last.op == operation::constant ? hash(numbers_[last.a]) : hash(last)) & hash_mask_;
      while (table_[place] != size_) place = (place + 1) & hash_mask_;
      table_[place] = 0;
    }
    while (numbers_.size() > kept.numbers) numbers_.pop();
    while (symbols_.size() > kept.symbols) symbols_.pop();
    while (externals_.size() > kept.externals) externals_.pop();
    has_lists_ = kept.has_lists;
  }

  static constexpr int most_constant = 1 << 20; ///< nodes in constant evaluation

  /// The nodes in constant evaluation, where the compiler stores only those that are written.
  struct block {
    node value[most_constant]{};
  };
  /// The hash table there. base::zeros provides such an array too, but only by a call.
  struct hash_table {
    int value[2 * most_constant]{};
  };

  /// The nodes of a graph, as arrays that can outlive constant evaluation, where a single step copies them
  /// and the hash table. At run time, which finds the places of the nodes again, the table remains empty.
  struct stored {
    int size = 0;
    int room = 0;
    bool has_lists = false;
    block nodes{};
    hash_table table{};
  };

  /// Stores the nodes, of which there must be at most `most_constant`.
  constexpr void store(stored& into) const {
    into.size = size_, into.room = room_, into.has_lists = has_lists_;
    if (__builtin_is_constant_evaluated())
      into.nodes = *block_, into.table = *slots_;
    else
      copy(into.nodes.value, nodes_, size_);
  }
  /// Restores stored nodes with their numbers and symbols.
  constexpr void restore(sequence<number>&& numbers, sequence<symbol>&& symbols, const stored& from) {
    numbers_ = static_cast<sequence<number>&&>(numbers);
    symbols_ = static_cast<sequence<symbol>&&>(symbols);
    has_lists_ = from.has_lists;
    allocate(from.room);
    if (__builtin_is_constant_evaluated()) {
      *block_ = from.nodes, *slots_ = from.table;
      size_ = from.size;
    } else {
      copy(nodes_, from.nodes.value, from.size);
      index_nodes(from.size);
    }
  }

private:
  static constexpr int least_room = 1 << 9;

  static constexpr unsigned hash(const number& value) {
    const std::uint64_t fraction =
        static_cast<std::uint64_t>(value.numerator) * 31 + static_cast<std::uint64_t>(value.denominator);
    const auto real = std::bit_cast<std::uint64_t>(value.real);
    const unsigned mixed = (static_cast<unsigned>(fraction) * 2654435761u) ^
                           (static_cast<unsigned>(real ^ (real >> 32)) * 2246822519u);
    return mixed ^ (mixed >> 15);
  }
  /// Takes a reference, because g++ caches every constexpr call whose arguments are plain values, and there
  /// are many such calls. The factors are small, because g++ stores every number that occurs in a constant
  /// expression once: numbers that occur often cost neither time nor memory.
  static constexpr unsigned hash(const node& n) {
    if (!__builtin_is_constant_evaluated()) // where the number of nodes is not limited
      return static_cast<unsigned>(n.a) * 211u + static_cast<unsigned>(n.b) * 5u +
             static_cast<unsigned>(n.op);
    return static_cast<unsigned>(n.a * 211 + n.b * 5 + static_cast<int>(n.op));
  }

  /// The slot of a constant in the hash table, or the free slot where it belongs.
  constexpr int place_of(const number& wanted) const {
    unsigned place = hash(wanted) & hash_mask_;
    for (; table_[place] != 0; place = (place + 1) & hash_mask_) {
      const node& present = nodes_[table_[place] - 1];
      if (present.op == operation::constant && numbers_[present.a] == wanted) break;
    }
    return static_cast<int>(place);
  }

  constexpr int append(const node& added, int place) {
    if (added.op >= operation::pair) has_lists_ = true;
    if (size_ == room_) {
      grow(added);
      return size_ - 1;
    }
    nodes_[size_] = added;
    table_[place] = ++size_;
    return size_ - 1;
  }
  constexpr void grow(const node& added) {
    const node kept = added; // `added` may refer to one of these nodes
    const int count = size_;
    if (__builtin_is_constant_evaluated()) {
      allocate_table(4 * room_);
    } else {
      node* const before = nodes_;
      nodes_ = nullptr;
      allocate(4 * room_);
      copy(nodes_, before, count);
      delete[] before;
    }
    nodes_[count] = kept;
    index_nodes(count + 1);
  }

  constexpr int find_at_run_time(const node& wanted) const {
    unsigned place = hash(wanted) & hash_mask_;
    for (int next = table_[place]; next != 0; next = table_[place = (place + 1) & hash_mask_]) {
      const node& present = nodes_[next - 1];
      if (present.a == wanted.a && present.b == wanted.b && present.op == wanted.op) return next - 1;
    }
    return -1;
  }
  constexpr int find_or_append_at_run_time(const node& wanted) {
    unsigned place = hash(wanted) & hash_mask_;
    for (int next = table_[place]; next != 0; next = table_[place = (place + 1) & hash_mask_]) {
      const node& present = nodes_[next - 1];
      if (present.a == wanted.a && present.b == wanted.b && present.op == wanted.op) return next - 1;
    }
    return append(wanted, static_cast<int>(place));
  }

  /// Enters distinct nodes into the hash table.
  constexpr void index_nodes(int count) {
    if (__builtin_is_constant_evaluated())
      index_nodes(block_->value, slots_->value, count);
    else
      index_nodes(nodes_, table_, count);
    size_ = count;
  }
  /// Allocates an empty graph.
  constexpr void allocate(int nodes) {
    release();
    if (__builtin_is_constant_evaluated()) {
      block_ = new block;
      nodes_ = block_->value;
    } else {
      nodes_ = new node[static_cast<unsigned>(nodes)];
    }
    allocate_table(nodes);
  }
  /// The table has at least twice as many slots as there may be nodes.
  constexpr void allocate_table(int nodes) {
    room_ = nodes;
    if (__builtin_is_constant_evaluated()) {
      delete slots_;
      slots_ = new hash_table();
      table_ = slots_->value;
    } else {
      places_ = base::zeros<int>(2 * nodes);
      table_ = places_.begin();
    }
    hash_mask_ = 2 * static_cast<unsigned>(nodes) - 1;
  }
  constexpr void release() {
    if (block_ != nullptr)
      delete block_;
    else
      delete[] nodes_;
    delete slots_;
    block_ = nullptr;
    slots_ = nullptr;
    nodes_ = nullptr;
  }

  block* block_ = nullptr;      ///< only in constant evaluation
  hash_table* slots_ = nullptr; ///< likewise
  node* nodes_ = nullptr;
  int size_ = 0;
  int room_ = 0;
  base::zeros<int> places_{};
  int* table_ = nullptr; ///< open addressing: one more than the number of a node; 0 marks a free slot
  unsigned hash_mask_ = 0;
  sequence<number> numbers_{};
  sequence<symbol> symbols_{};
  sequence<const external_function*> externals_{};
  bool has_lists_ = false;
  bool has_integer_zero_ = false;
  bool has_reversed_bounds_ = false;
};

} // namespace kanexpr::symbolic
