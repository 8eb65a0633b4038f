#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

#include <cstdint>

namespace kanexpr::lower {

using base::sequence;
using symbolic::graph;
using symbolic::operation;

/// Orders nodes so that few values are live simultaneously and more of them stay in registers.
///
/// Among the nodes whose operands are available, the one that is the last use of the most values comes next.
/// Of several, it is the one after which another node becomes available that shrinks the set of live values
/// most; further ties are resolved by the order of the graph. Products used by only one sum directly precede
/// it, because processors can contract a product and a sum into one operation. The code accesses arrays
/// directly because compilers interpret every call.
class step_order {
public:
  /// Orders the `live` nodes of the graph, except leaves and nodes that already have a slot.
  constexpr step_order(const graph& g, const sequence<int>& live, const sequence<int>& slot_of,
                       const sequence<int>& results)
      : nodes_(g.begin()), place_of_(g.size(), none), place_(place_of_.begin()) {
    values_.reserve(live.size());
    for (int id : live)
      if (nodes_[id].op > operation::symbol) place_[id] = values_.push(id);
    const int count = values_.size();
    for (sequence<int>* each :
         {&uses_of_, &waits_for_, &joined_to_, &first_operand_of_, &gain_of_, &prospect_of_})
      each->resize(count, 0);
    first_user_of_.resize(count + 1, 0);
    rank_of_.resize(count, waiting);
    uses_ = uses_of_.begin(), waits_ = waits_for_.begin(), joins_ = joined_to_.begin();
    first_operand_ = first_operand_of_.begin(), first_user_ = first_user_of_.begin();
    rank_ = rank_of_.begin(), gain_ = gain_of_.begin(), prospect_ = prospect_of_.begin();
    words_ = count / 64 + 1;
    ready_of_.resize(ranks * words_, 0);
    ready_ = ready_of_.begin();
    for (int k = 0; k < count; ++k)
      if (slot_of[values_[k]] != none) rank_[k] = done;
    join_products(results);
    list_operands();
    list_users();
    order_.reserve(count);
  }
  step_order(const step_order&) = delete;
  step_order& operator=(const step_order&) = delete;

  constexpr sequence<int> run() {
    for (int k = 0, end = values_.size(); k < end; ++k) {
      if (rank_[k] != waiting) continue;
      if (waits_[k] == 0) offer(k);
      if (waits_[k] == 1) raise_missing_operand_of(k);
    }
    while (true) {
      const int k = take();
      if (k == none) return static_cast<sequence<int>&&>(order_);
      put(k);
    }
  }

private:
  static constexpr int none = -1;
  static constexpr int waiting = -1, joined = -2, done = -3; ///< used in place of a rank
  static constexpr int prospects = 3;         ///< none, one that adds no value, one that shrinks the set
  static constexpr int ranks = 6 * prospects; ///< a step is the last use of at most four values
  /// While more values than this are live, a step that adds no value is a prospect too.
  static constexpr int few = 64;

  constexpr int second_operand(const symbolic::node& n) const {
    if (n.op <= operation::power) return n.op == operation::negate ? none : n.b;
    return symbolic::is_binary(n.op) && !symbolic::has_index_operand(n.op) ? n.b : none;
  }

  /// Joins products that only one sum uses; a result counts as used by the caller.
  constexpr void join_products(const sequence<int>& results) {
    for (int id : results)
      if (place_[id] != none) ++uses_[place_[id]];
    for (int k = 0, end = values_.size(); k < end; ++k) {
      const symbolic::node& n = nodes_[values_[k]];
      const int a = place_[n.a], second = second_operand(n), b = second == none ? none : place_[second];
      if (a != none) ++uses_[a];
      if (b != none) ++uses_[b];
      if (n.op != operation::add && n.op != operation::subtract) continue;
      if (a != none && nodes_[n.a].op == operation::multiply) ++joins_[a];
      if (b != none && nodes_[n.b].op == operation::multiply) ++joins_[b];
    }
    for (int k = 0, end = values_.size(); k < end; ++k) {
      const bool is_joined = joins_[k] == 1 && uses_[k] == 1 && rank_[k] == waiting;
      joins_[k] = 0;
      if (is_joined) rank_[k] = joined;
    }
  }

  /// Lists the operands of every step, including those of joined products, each value once.
  constexpr void list_operands() {
    operands_of_.reserve(3 * values_.size());
    for (int k = 0, end = values_.size(); k < end; ++k) {
      if (rank_[k] != waiting) continue;
      const int first = first_operand_[k] = operands_of_.size();
      const symbolic::node& n = nodes_[values_[k]];
      const int second = second_operand(n);
      list_operand(k, first, n.a);
      if (second != none && second != n.a) list_operand(k, first, second);
      operands_of_.push(none); // end marker
    }
    operands_ = operands_of_.begin();
  }

  constexpr void list_operand(int k, int first, int id) {
    const int operand = place_[id];
    if (operand == none) return; // not computed by a step
    if (rank_[operand] == joined) {
      joins_[k] = 1;
      list_operand(k, first, nodes_[id].a);
      list_operand(k, first, nodes_[id].b);
      return;
    }
    for (int i = first, end = operands_of_.size(); i < end; ++i)
      if (operands_of_[i] == operand) return;
    operands_of_.push(operand);
  }

  /// Lists the users of all values, grouped by value.
  constexpr void list_users() {
    const int count = values_.size();
    for (int k = 0; k < count; ++k) uses_[k] = 0;
    for (int k = 0; k < count; ++k) {
      if (rank_[k] != waiting) continue;
      for (int i = first_operand_[k]; operands_[i] != none; ++i) {
        ++uses_[operands_[i]];
        if (rank_[operands_[i]] != done) ++waits_[k];
      }
    }
    int place = 0;
    for (int k = 0; k < count; ++k) first_user_[k] = place += uses_[k];
    first_user_[count] = place;
    users_of_.resize(place);
    users_ = users_of_.begin();
    for (int k = count - 1; k >= 0; --k) {
      if (rank_[k] != waiting) continue;
      for (int i = first_operand_[k]; operands_[i] != none; ++i) users_[--first_user_[operands_[i]]] = k;
    }
    count_gains();
  }

  /// A list takes its elements over as soon as they are computed; it is not a use for which they stay live.
  constexpr void count_gains() {
    const int count = values_.size();
    for (int k = 0; k < count; ++k)
      if (rank_[k] == waiting && is_list(k))
        for (int i = first_operand_[k]; operands_[i] != none; ++i) --uses_[operands_[i]];
    for (int k = 0; k < count; ++k) {
      if (rank_[k] != waiting) continue;
      int gain = uses_[k] > 0 ? 0 : 1;
      if (!is_list(k))
        for (int i = first_operand_[k]; operands_[i] != none; ++i)
          if (uses_[operands_[i]] == 1) ++gain;
      gain_[k] = gain;
    }
  }

  constexpr bool is_list(int k) const { return nodes_[values_[k]].op == operation::pair; }

  constexpr void offer(int k) {
    if (nodes_[values_[k]].op == operation::symmetric_solve) {
      last_.push(k);
      return;
    }
    const int rank = prospects * gain_[k] + prospect_[k], word = k / 64;
    rank_[k] = rank;
    ready_[rank * words_ + word] |= std::uint64_t{1} << (k % 64);
    if (count_[rank]++ == 0 || word < first_[rank]) first_[rank] = word;
    filled_ |= 1U << rank;
  }

  constexpr void withdraw(int k) {
    const int rank = rank_[k];
    ready_[rank * words_ + k / 64] &= ~(std::uint64_t{1} << (k % 64));
    if (--count_[rank] == 0) filled_ &= ~(1U << rank);
  }

  /// Returns the first step of a rank that has some.
  constexpr int first_of(int rank) {
    const int row = rank * words_;
    const std::uint64_t* const ready = ready_ + row;
    int word = first_[rank];
    while (ready[word] == 0) ++word;
    first_[rank] = word;
    return 64 * word + __builtin_ctzll(ready[word]);
  }

  /// Removes and returns the best step that is ready.
  constexpr int take() {
    if (filled_ == 0) return next_of_last_ < last_.size() ? last_[next_of_last_++] : none;
    const int rank = 31 - __builtin_clz(filled_);
    int k = first_of(rank);
    if (rank % prospects == 1 && live_ <= few && count_[rank - 1] != 0) {
      const int other = first_of(rank - 1);
      if (other < k) k = other;
    }
    withdraw(k);
    return k;
  }

  constexpr void put(int k) {
    const int id = values_[k];
    if (joins_[k] != 0)
      for (int product : {nodes_[id].a, nodes_[id].b})
        if (place_[product] != none && rank_[place_[product]] == joined) {
          order_.push(product);
          rank_[place_[product]] = done;
        }
    order_.push(id);
    rank_[k] = done;
    const int begin = first_user_[k], end = first_user_[k + 1];
    if (uses_[k] > 0) ++live_;
    for (int i = begin; i < end; ++i) {
      const int missing = --waits_[users_[i]];
      if (missing == 0) offer(users_[i]);
      if (missing == 1) raise_missing_operand_of(users_[i]);
    }
    if (is_list(k)) return;
    for (int i = first_operand_[k]; operands_[i] != none; ++i) {
      const int left = --uses_[operands_[i]];
      if (left == 1) favour_last_user_of(operands_[i]);
      if (left == 0) --live_;
    }
  }

  constexpr void favour_last_user_of(int value) {
    for (int i = first_user_[value]; i < first_user_[value + 1]; ++i) {
      const int user = users_[i];
      if (rank_[user] == done || is_list(user)) continue;
      if (rank_[user] >= 0) withdraw(user);
      ++gain_[user];
      if (rank_[user] >= 0)
        offer(user);
      else if (waits_[user] == 1)
        raise_missing_operand_of(user);
      return;
    }
  }

  /// Raises the prospect of the only operand for which a step waits.
  constexpr void raise_missing_operand_of(int k) {
    const int prospect = gain_[k] < prospects ? gain_[k] : prospects - 1;
    int i = first_operand_[k];
    while (rank_[operands_[i]] == done) ++i;
    const int operand = operands_[i];
    if (prospect <= prospect_[operand]) return;
    if (rank_[operand] >= 0) withdraw(operand);
    prospect_[operand] = prospect;
    if (rank_[operand] >= 0) offer(operand);
  }

  const symbolic::node* nodes_;
  sequence<int> place_of_; ///< the index among the values, by node
  sequence<int> values_{}; ///< the nodes computed by steps
  sequence<int> uses_of_{}, waits_for_{}, joined_to_{}, first_operand_of_{}, first_user_of_{}, rank_of_{};
  sequence<int> gain_of_{}, prospect_of_{};
  sequence<int> operands_of_{}, users_of_{};
  sequence<std::uint64_t> ready_of_{}; ///< one bit per value, by rank
  sequence<int> order_{};
  sequence<int> last_{}; ///< symmetric systems, which wait until nothing else is ready
  int next_of_last_ = 0;
  int* place_;
  int* uses_ = nullptr;          ///< remaining uses, by value
  int* waits_ = nullptr;         ///< operands not yet available, by value
  int* joins_ = nullptr;         ///< whether products are joined to it
  int* first_operand_ = nullptr; ///< the index of its first operand
  int* first_user_ = nullptr;    ///< the index of its first user
  int* rank_ = nullptr;          ///< the rank if ready; otherwise the reason why it is not
  int* gain_ = nullptr;          ///< one plus the number of values by which it shrinks the live set
  int* prospect_ = nullptr;      ///< the best gain of a step that waits for it only, bounded
  std::uint64_t* ready_ = nullptr;
  int words_ = 0;            ///< the number of 64-bit words per rank
  int live_ = 0;             ///< the number of values that steps still need
  std::uint32_t filled_ = 0; ///< one bit per rank that has steps
  int count_[ranks]{};       ///< the number of set bits
  int first_[ranks]{};       ///< no preceding word has a set bit
  const int* operands_ = nullptr;
  int* users_ = nullptr;
};

} // namespace kanexpr::lower
