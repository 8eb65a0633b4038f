#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/base/zeros.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

#include <cstdint>
#include <type_traits>
#include <utility>

namespace kanexpr::lower {

using base::sequence;
using symbolic::graph;
using symbolic::operation;

/// Orders nodes so that few values are live simultaneously and more of them stay in registers.
///
/// Among the nodes whose operands are available, the one that is the last use of the most values comes next.
/// Of several, it is the one after which another node becomes available that shrinks the set of live values
/// most; further ties are resolved by the order of the graph. Products used by only one sum directly precede
/// it, because processors can contract a product and a sum into one operation.
///
/// The parameter states whether the order is found in constant evaluation, where the loops access the arrays
/// themselves (base::zeros explains why).
template <bool is_constant>
class step_order {
public:
  /// Orders the `count` nodes in `live`, except leaves and nodes that already have a slot (stored as one
  /// more).
  constexpr step_order(const graph& g, const base::zeros<int>& live, int count,
                       const base::zeros<int>& slot_of, const sequence<int>& results)
      : g_(g), places_(g.size()), values_(count), uses_(count), waits_(count), joins_(count),
        first_operands_(count), first_users_(count + 1), ranks_(count), gains_(count), prospects_(count),
        operands_(3 * count), users_(3 * count), ready_(ranks * (count / 64 + 1)), order_(count) {
    const auto& nodes = g.elements<is_constant>();
    const auto& ids = live.elements<is_constant>();
    const auto& slot_at = slot_of.elements<is_constant>();
    auto& place = places_.elements<is_constant>();
    auto& value = values_.elements<is_constant>();
    auto& rank = ranks_.elements<is_constant>();
    int values = 0;
    for (int i = 0; i < count; ++i) {
      const int id = ids[i];
      if (nodes[id].op <= operation::symbol) continue;
      rank[values] = slot_at[id] == 0 ? waiting : done;
      value[values] = id;
      place[id] = ++values;
    }
    count_ = values;
    words_ = values / 64 + 1;
    join_products(results);
    list_operands();
    list_users();
    count_gains();
  }
  step_order(const step_order&) = delete;
  step_order& operator=(const step_order&) = delete;

  /// Returns the nodes in order.
  constexpr const base::zeros<int>& run() {
    const auto& wait = waits_.elements<is_constant>();
    const auto& rank = ranks_.elements<is_constant>();
    for (int k = 0; k < count_; ++k) {
      if (rank[k] != waiting) continue;
      if (wait[k] == 0) offer(k);
      if (wait[k] == 1) raise_missing_operand_of(k);
    }
    put_all();
    return order_;
  }
  constexpr int size() const { return ordered_; }

private:
  static constexpr int none = -1;
  static constexpr int waiting = -1, joined = -2, done = -3; ///< used in place of a rank
  static constexpr int prospects = 3;         ///< none, one that adds no value, one that shrinks the set
  static constexpr int ranks = 6 * prospects; ///< a step is the last use of at most four values
  /// While more values than this are live, a step that adds no value is a prospect too.
  static constexpr int few = 64;

  static constexpr bool has_second_operand(operation op) {
    return op <= operation::power ? op != operation::negate
                                  : symbolic::is_binary(op) && !symbolic::has_index_operand(op);
  }

  /// Joins products that only one sum uses; a result counts as used by the caller.
  constexpr void join_products(const sequence<int>& results) {
    const auto& nodes = g_.elements<is_constant>();
    const auto& place = places_.elements<is_constant>();
    const auto& value = values_.elements<is_constant>();
    auto& use = uses_.elements<is_constant>();
    auto& join = joins_.elements<is_constant>();
    auto& rank = ranks_.elements<is_constant>();
    for (int k = 0; k < count_; ++k) use[k] = join[k] = 0;
    for (int id : results)
      if (place[id] != 0) ++use[place[id] - 1];
    for (int k = 0; k < count_; ++k) {
      const int id = value[k];
      const operation op = nodes[id].op;
      const bool is_sum = op == operation::add || op == operation::subtract;
      const int a = nodes[id].a, first = place[a];
      if (first != 0) {
        ++use[first - 1];
        if (is_sum && nodes[a].op == operation::multiply) ++join[first - 1];
      }
      if (op > operation::power ? !has_second_operand(op) : op == operation::negate) continue;
      const int b = nodes[id].b, second = place[b];
      if (second == 0) continue;
      ++use[second - 1];
      if (is_sum && nodes[b].op == operation::multiply) ++join[second - 1];
    }
    for (int k = 0; k < count_; ++k) {
      if (join[k] == 0) continue;
      if (join[k] == 1 && use[k] == 1 && rank[k] == waiting) rank[k] = joined;
      join[k] = 0;
    }
  }

  /// Lists the operands of every step, including those of joined products, each value once.
  constexpr void list_operands() {
    const auto& nodes = g_.elements<is_constant>();
    const auto& place = places_.elements<is_constant>();
    const auto& value = values_.elements<is_constant>();
    const auto& rank = ranks_.elements<is_constant>();
    auto& join = joins_.elements<is_constant>();
    auto& first_operand = first_operands_.elements<is_constant>();
    auto& operands = operands_.elements<is_constant>();
    int listed = 0;
    for (int k = 0; k < count_; ++k) {
      first_operand[k] = listed;
      if (rank[k] != waiting) continue;
      const int first = listed, id = value[k];
      int open[4]{nodes[id].a}; // the operands that remain to be listed, the last one first
      int count = 1;
      if (const operation op = nodes[id].op;
          (op > operation::power ? has_second_operand(op) : op != operation::negate) &&
          nodes[id].b != open[0])
        open[1] = open[0], open[0] = nodes[id].b, count = 2;
      while (count > 0) {
        const int each = open[--count], operand = place[each] - 1;
        if (operand == none) continue; // not computed by a step
        if (rank[operand] == joined) {
          join[k] = 1;
          open[count++] = nodes[each].b, open[count++] = nodes[each].a;
          continue;
        }
        int i = first;
        while (i < listed && operands[i] != operand) ++i;
        if (i == listed) operands[listed++] = operand;
      }
      operands[listed++] = none; // end marker
    }
  }

  /// Lists the users of all values, grouped by value.
  constexpr void list_users() {
    const auto& rank = ranks_.elements<is_constant>();
    const auto& first_operand = first_operands_.elements<is_constant>();
    const auto& operands = operands_.elements<is_constant>();
    auto& use = uses_.elements<is_constant>();
    auto& wait = waits_.elements<is_constant>();
    auto& first_user = first_users_.elements<is_constant>();
    for (int k = 0; k < count_; ++k) use[k] = 0;
    for (int k = 0; k < count_; ++k) {
      int missing = 0;
      if (rank[k] == waiting)
        for (int i = first_operand[k]; operands[i] != none; ++i) {
          ++use[operands[i]];
          if (rank[operands[i]] != done) ++missing;
        }
      wait[k] = missing;
    }
    int place = 0;
    for (int k = 0; k < count_; ++k) first_user[k] = place += use[k];
    first_user[count_] = place;
    auto& users = users_.elements<is_constant>();
    for (int i = 0; i < place; ++i) users[i] = 0;
    for (int k = count_ - 1; k >= 0; --k) {
      if (rank[k] != waiting) continue;
      for (int i = first_operand[k]; operands[i] != none; ++i) users[--first_user[operands[i]]] = k;
    }
  }

  /// A list takes its elements over as soon as they are computed; it is not a use for which they stay live.
  constexpr void count_gains() {
    const auto& nodes = g_.elements<is_constant>();
    const auto& value = values_.elements<is_constant>();
    const auto& rank = ranks_.elements<is_constant>();
    const auto& first_operand = first_operands_.elements<is_constant>();
    const auto& operands = operands_.elements<is_constant>();
    auto& use = uses_.elements<is_constant>();
    auto& gain = gains_.elements<is_constant>();
    for (int k = 0; k < count_; ++k)
      if (rank[k] == waiting && nodes[value[k]].op == operation::pair)
        for (int i = first_operand[k]; operands[i] != none; ++i) --use[operands[i]];
    for (int k = 0; k < count_; ++k) {
      int gained = 0;
      if (rank[k] == waiting) {
        gained = use[k] > 0 ? 0 : 1;
        if (nodes[value[k]].op != operation::pair)
          for (int i = first_operand[k]; operands[i] != none; ++i)
            if (use[operands[i]] == 1) ++gained;
      }
      gain[k] = gained;
    }
  }

  constexpr void offer(int k) {
    if (g_.elements<is_constant>()[value_[k]].op == operation::symmetric_solve) {
      last_.push(k);
      return;
    }
    const int rank = prospects * gain_[k] + prospect_[k], word = k / 64;
    rank_[k] = rank;
    ready_word_[rank * words_ + word] |= std::uint64_t{1} << (k % 64);
    if (filled_[rank]++ == 0 || word < first_[rank]) first_[rank] = word;
    is_filled_ |= 1U << rank;
  }

  constexpr void withdraw(int k) {
    const int rank = rank_[k];
    ready_word_[rank * words_ + k / 64] &= ~(std::uint64_t{1} << (k % 64));
    if (--filled_[rank] == 0) is_filled_ &= ~(1U << rank);
  }

  /// Puts the best step that is ready, again and again, without calls, because compilers remember each.
  constexpr void put_all() {
    const auto& nodes = g_.elements<is_constant>();
    const auto& place = places_.elements<is_constant>();
    const auto& value = values_.elements<is_constant>();
    const auto& join = joins_.elements<is_constant>();
    const auto& gain = gains_.elements<is_constant>();
    const auto& first_operand = first_operands_.elements<is_constant>();
    const auto& operands = operands_.elements<is_constant>();
    const auto& first_user = first_users_.elements<is_constant>();
    const auto& users = users_.elements<is_constant>();
    const auto& prospect = prospects_.elements<is_constant>();
    auto& ready = ready_.elements<is_constant>();
    auto& use = uses_.elements<is_constant>();
    auto& wait = waits_.elements<is_constant>();
    auto& rank = ranks_.elements<is_constant>();
    auto& order = order_.elements<is_constant>();
    int next = 0, next_of_last = 0;
    while (is_filled_ != 0 || next_of_last < last_.size()) {
      int k = 0;
      if (is_filled_ == 0) {
        k = last_[next_of_last++];
      } else {
        int best = 31 - __builtin_clz(is_filled_), word = first_[best];
        while (ready[best * words_ + word] == 0) ++word;
        first_[best] = word;
        k = 64 * word + __builtin_ctzll(ready[best * words_ + word]);
        if (best % prospects == 1 && live_ <= few && filled_[best - 1] != 0) {
          const int below = best - 1;
          word = first_[below];
          while (ready[below * words_ + word] == 0) ++word;
          first_[below] = word;
          const int other = 64 * word + __builtin_ctzll(ready[below * words_ + word]);
          if (other < k) k = other, best = below;
        }
        ready[best * words_ + k / 64] &= ~(std::uint64_t{1} << (k % 64));
        if (--filled_[best] == 0) is_filled_ &= ~(1U << best);
      }
      const int id = value[k];
      if (join[k] != 0) {
        for (int side = 0; side < 2; ++side) {
          const int product = side == 0 ? nodes[id].a : nodes[id].b, joined_product = place[product] - 1;
          if (joined_product == none || rank[joined_product] != joined) continue;
          order[next++] = product;
          rank[joined_product] = done;
        }
      }
      order[next++] = id;
      rank[k] = done;
      if (use[k] > 0) ++live_;
      for (int i = first_user[k], end = first_user[k + 1]; i < end; ++i) {
        const int user = users[i], missing = wait[user] - 1;
        wait[user] = missing;
        if (missing == 1 && gain[user] > 0) raise_missing_operand_of(user);
        if (missing != 0) continue;
        if (nodes[value[user]].op == operation::symmetric_solve) {
          last_.push(user);
          continue;
        }
        const int own = prospects * gain[user] + prospect[user], word = user / 64;
        rank[user] = own;
        ready[own * words_ + word] |= std::uint64_t{1} << (user % 64);
        if (filled_[own]++ == 0 || word < first_[own]) first_[own] = word;
        is_filled_ |= 1U << own;
      }
      if (nodes[id].op == operation::pair) continue;
      for (int i = first_operand[k]; operands[i] != none; ++i) {
        const int operand = operands[i], left = use[operand] - 1;
        use[operand] = left;
        if (left == 1) favour_last_user_of(operand);
        if (left == 0) --live_;
      }
    }
    ordered_ = next;
  }

  constexpr void favour_last_user_of(int of) {
    const auto& nodes = g_.elements<is_constant>();
    for (int i = first_user_[of], end = first_user_[of + 1]; i < end; ++i) {
      const int user = user_[i], rank = rank_[user];
      if (rank == done || nodes[value_[user]].op == operation::pair) continue;
      const bool is_offered = rank >= 0;
      if (is_offered) withdraw(user);
      ++gain_[user];
      if (is_offered)
        offer(user);
      else if (wait_[user] == 1)
        raise_missing_operand_of(user);
      return;
    }
  }

  /// Raises the prospect of the only operand for which a step waits.
  constexpr void raise_missing_operand_of(int k) {
    const int gain = gain_[k], prospect = gain < prospects ? gain : prospects - 1;
    int i = first_operand_[k];
    while (rank_[operand_[i]] == done) ++i;
    const int operand = operand_[i];
    if (prospect <= prospect_[operand]) return;
    const bool is_offered = rank_[operand] >= 0;
    if (is_offered) withdraw(operand);
    prospect_[operand] = prospect;
    if (is_offered) offer(operand);
  }

  const graph& g_;
  base::zeros<int> places_; ///< one more than the index among the values, by node
  base::zeros<int> values_; ///< the nodes computed by steps
  // by value
  base::zeros<int> uses_;             ///< remaining uses
  base::zeros<int> waits_;            ///< operands not yet available
  base::zeros<int> joins_;            ///< whether products are joined to it
  base::zeros<int> first_operands_;   ///< the index of its first operand
  base::zeros<int> first_users_;      ///< the index of its first user
  base::zeros<int> ranks_;            ///< the rank if ready; otherwise the reason why it is not
  base::zeros<int> gains_;            ///< one plus the number of values by which it shrinks the live set
  base::zeros<int> prospects_;        ///< the best gain of a step that waits for it only, bounded
  base::zeros<int> operands_, users_; ///< as indices among the values
  base::zeros<std::uint64_t> ready_;  ///< one bit per value, by rank
  base::zeros<int> order_;

  // the arrays themselves, for functions that are called for each step
  template <class Number>
  using array = std::remove_reference_t<
      decltype(std::declval<base::zeros<Number>&>().template elements<is_constant>())>;
  array<int>&value_{values_.template elements<is_constant>()},
      &wait_{waits_.template elements<is_constant>()},
      &first_operand_{first_operands_.template elements<is_constant>()},
      &first_user_{first_users_.template elements<is_constant>()},
      &rank_{ranks_.template elements<is_constant>()}, &gain_{gains_.template elements<is_constant>()},
      &prospect_{prospects_.template elements<is_constant>()},
      &operand_{operands_.template elements<is_constant>()}, &user_{users_.template elements<is_constant>()};
  array<std::uint64_t>& ready_word_{ready_.template elements<is_constant>()};

  sequence<int> last_{};        ///< symmetric systems, which wait until nothing else is ready
  int count_ = 0;               ///< the number of values
  int ordered_ = 0;             ///< the number of those that are ordered
  int words_ = 0;               ///< the number of 64-bit words per rank
  int live_ = 0;                ///< the number of values that steps still need
  std::uint32_t is_filled_ = 0; ///< one bit per rank that has steps
  int filled_[ranks]{};         ///< the number of set bits
  int first_[ranks]{};          ///< no preceding word has a set bit
};

} // namespace kanexpr::lower
