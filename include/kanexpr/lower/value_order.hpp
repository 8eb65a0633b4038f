#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/base/zeros.hpp>

#include <cstdint>

namespace kanexpr::lower {

using base::sequence;

/// When a value comes.
enum class turn : char {
  by_rank,     ///< by the rule of value_order
  list,        ///< the same; a list takes its operands over at once, so that they need not stay live for it
  immediately, ///< as soon as its operands are available
  last,        ///< when nothing else is available
  joined,      ///< directly before the only value that uses it
  done         ///< before all others
};

/// Values to be ordered, and the operands of each.
struct unordered_values {
  int count = 0;
  base::zeros<turn> turns;
  /// Of all values, each once, followed by `end`; those of joined values are of their users. The joined
  /// values of a value precede its operands, the first one last.
  base::zeros<int> operands;
  base::zeros<int> first_operands; ///< of each value, where its operands begin

  static constexpr int end = -1;
  /// A joined value among the operands.
  static constexpr int joined(int value) { return end - 1 - value; }

  constexpr unordered_values(int most, int most_operands)
      : turns(most), operands(1 + most_operands + most), first_operands(most) {
    operands[0] = end;
  }
};

/// Orders values so that few of them are live simultaneously and more of them stay in registers.
///
/// Among the values whose operands are available, the one that is the last use of the most values comes next.
/// Of several, it is the one after which another value becomes available that shrinks the set of live values
/// most; further ties are resolved by their numbers.
///
/// The parameter states whether the order is found in constant evaluation, where the loops access the arrays
/// themselves (base::zeros explains why).
template <bool is_constant>
class value_order {
public:
  constexpr explicit value_order(unordered_values& all)
      : count_(all.count), words_(count_ / 64 + 1), users_(all.operands.size()),
        turn_(all.turns.elements<is_constant>()), first_operand_(all.first_operands.elements<is_constant>()),
        operand_(all.operands.elements<is_constant>()) {
    list_users();
    count_gains();
    for (int k = 0; k < count_; ++k) {
      if (turn_[k] >= turn::joined) continue;
      if (wait_[k] == 0) offer(k);
      if (wait_[k] == 1) raise_missing_operand_of(k);
    }
  }
  value_order(const value_order&) = delete;
  value_order& operator=(const value_order&) = delete;

  /// Puts the best value that is available, again and again, from `next` in `ordered`, and returns how many
  /// there are then; without calls, because compilers remember each.
  constexpr int put_all(base::zeros<int>& ordered, int next) {
    auto& order = ordered.elements<is_constant>();
    auto& ready = ready_;
    auto &use = use_, &wait = wait_, &rank = rank_;
    auto& when = turn_;
    const auto &gain = gain_, &prospect = prospect_, &operand = operand_, &user = user_;
    int next_of_last = 0;
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
      const int first = first_operand_[k];
      for (int i = first - 1; operand[i] < unordered_values::end; --i) {
        const int product = unordered_values::joined(operand[i]);
        order[next++] = product;
        when[product] = turn::done;
      }
      order[next++] = k;
      const bool is_list = when[k] == turn::list;
      when[k] = turn::done;
      if (use[k] > 0) ++live_;
      for (int i = first_user_[k], end = first_user_[k + 1]; i < end; ++i) {
        const int by = user[i], missing = wait[by] - 1;
        wait[by] = missing;
        if (missing == 1 && gain[by] > 0) raise_missing_operand_of(by);
        if (missing != 0) continue;
        if (when[by] > turn::list) {
          offer(by);
          continue;
        }
        const int to = prospects * gain[by] + prospect[by], in = by / 64;
        rank[by] = to + 1;
        ready[to * words_ + in] |= std::uint64_t{1} << (by % 64);
        if (filled_[to]++ == 0 || in < first_[to]) first_[to] = in;
        is_filled_ |= 1U << to;
      }
      if (is_list) continue;
      for (int i = first; operand[i] != unordered_values::end; ++i) {
        const int each = operand[i], left = use[each] - 1;
        use[each] = left;
        if (left == 1) favour_last_user_of(each);
        if (left == 0) --live_;
      }
    }
    return next;
  }

private:
  template <class Number>
  using array = typename base::zeros<Number>::template array<is_constant>;

  static constexpr int prospects = 3;             ///< none, one that adds no value, one that shrinks the set
  static constexpr int ranks = 6 * prospects + 1; ///< a value is the last use of at most four values
  static constexpr int of_immediate = ranks - 1;
  /// While more values than this are live, a value that adds none is a prospect too.
  static constexpr int few = 64;

  /// Lists the users of all values, grouped by value.
  constexpr void list_users() {
    const auto& operand = operand_;
    const auto& when = turn_;
    auto &use = use_, &wait = wait_, &user = user_, &first_user = first_user_;
    for (int k = 0; k < count_; ++k) {
      if (when[k] >= turn::joined) continue;
      int missing = 0;
      for (int i = first_operand_[k]; operand[i] != unordered_values::end; ++i) {
        ++use[operand[i]];
        if (when[operand[i]] != turn::done) ++missing;
      }
      wait[k] = missing;
    }
    int place = 0;
    for (int k = 0; k < count_; ++k) first_user[k] = place += use[k];
    first_user[count_] = place;
    for (int k = count_ - 1; k >= 0; --k) {
      if (when[k] >= turn::joined) continue;
      for (int i = first_operand_[k]; operand[i] != unordered_values::end; ++i)
        user[--first_user[operand[i]]] = k;
    }
  }

  constexpr void count_gains() {
    const auto& operand = operand_;
    const auto& when = turn_;
    auto &use = use_, &gain = gain_;
    for (int k = 0; k < count_; ++k)
      if (when[k] == turn::list)
        for (int i = first_operand_[k]; operand[i] != unordered_values::end; ++i) --use[operand[i]];
    for (int k = 0; k < count_; ++k) {
      if (when[k] >= turn::joined) continue;
      int gained = use[k] > 0 ? 0 : 1;
      if (when[k] != turn::list)
        for (int i = first_operand_[k]; operand[i] != unordered_values::end; ++i)
          if (use[operand[i]] == 1) ++gained;
      gain[k] = gained;
    }
  }

  constexpr void offer(int k) {
    if (turn_[k] == turn::last) {
      last_.push(k);
      return;
    }
    const int rank = turn_[k] == turn::immediately ? of_immediate : prospects * gain_[k] + prospect_[k],
              word = k / 64;
    rank_[k] = rank + 1;
    ready_[rank * words_ + word] |= std::uint64_t{1} << (k % 64);
    if (filled_[rank]++ == 0 || word < first_[rank]) first_[rank] = word;
    is_filled_ |= 1U << rank;
  }

  constexpr void withdraw(int k) {
    const int rank = rank_[k] - 1;
    rank_[k] = 0;
    ready_[rank * words_ + k / 64] &= ~(std::uint64_t{1} << (k % 64));
    if (--filled_[rank] == 0) is_filled_ &= ~(1U << rank);
  }

  constexpr void favour_last_user_of(int of) {
    int i = first_user_[of];
    while (i < first_user_[of + 1] && (turn_[user_[i]] == turn::done || turn_[user_[i]] == turn::list)) ++i;
    if (i == first_user_[of + 1]) return;
    const int user = user_[i];
    const bool is_offered = rank_[user] != 0;
    if (is_offered) withdraw(user);
    ++gain_[user];
    if (is_offered)
      offer(user);
    else if (wait_[user] == 1)
      raise_missing_operand_of(user);
  }

  /// Raises the prospect of the only operand for which a value waits.
  constexpr void raise_missing_operand_of(int k) {
    const int gain = gain_[k], prospect = gain < prospects ? gain : prospects - 1;
    int i = first_operand_[k];
    while (turn_[operand_[i]] == turn::done) ++i;
    const int operand = operand_[i];
    if (prospect <= prospect_[operand]) return;
    const bool is_offered = rank_[operand] != 0;
    if (is_offered) withdraw(operand);
    prospect_[operand] = prospect;
    if (is_offered) offer(operand);
  }

  int count_, words_; ///< 64-bit words per rank
  base::zeros<int> uses_{count_}, waits_{count_}, ranks_{count_}, gains_{count_}, prospects_{count_},
      first_users_{count_ + 1}, users_;
  base::zeros<std::uint64_t> ready_words_{ranks * words_};
  array<turn>& turn_;
  array<int>&first_operand_, &operand_;
  array<int>&use_{uses_.template elements<is_constant>()}, ///< remaining uses
      &wait_{waits_.template elements<is_constant>()},     ///< operands not yet available
      &rank_{ranks_.template elements<is_constant>()},     ///< of those that are ready, counted from 1
      &gain_{gains_.template elements<is_constant>()},     ///< one plus by how much it shrinks the live set
      &prospect_{prospects_.template elements<is_constant>()}, ///< the best gain of what waits for it only
      &first_user_{first_users_.template elements<is_constant>()},
      &user_{users_.template elements<is_constant>()};
  array<std::uint64_t>& ready_{ready_words_.template elements<is_constant>()}; ///< one bit per value, by rank

  sequence<int> last_{};   ///< values that wait until nothing else is available
  int live_ = 0;           ///< the number of values that others still need
  unsigned is_filled_ = 0; ///< one bit per rank that has values
  int filled_[ranks]{};    ///< the number of set bits
  int first_[ranks]{};     ///< no preceding word has a set bit
};

} // namespace kanexpr::lower
