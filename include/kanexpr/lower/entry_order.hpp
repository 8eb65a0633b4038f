#pragma once

#include <kanexpr/base/zeros.hpp>
#include <kanexpr/lower/lockstep_entries.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

#include <cstdint>

namespace kanexpr::lower::detail {

/// What the codes of all actions with a kind and an operation have in common: their remainder.
inline constexpr int digits = 4 * 64;
constexpr int code_of(lockstep_action::kind is, operation op) {
  return lockstep_action{is, op}.code() % digits;
}

/// Orders the entries of a function in lockstep so that few values are live simultaneously, by the rule of
/// `step_order`: the entry that is the last use of the most values comes next and, of several, one after
/// which such an entry becomes available. Values that are only stored come at once, and products that one sum
/// uses precede it. The code runs only in constant evaluation, and accesses arrays directly.
class entry_order {
public:
  /// Operands before `first_entry` are given; the first of them are numbers.
  constexpr entry_order(lockstep_entries& entries, int numbers, int first_entry)
      : entries_(entries), count_(entries.count), numbers_(numbers), first_entry_(first_entry),
        words_(count_ / 64 + 1) {}
  entry_order(const entry_order&) = delete;
  entry_order& operator=(const entry_order&) = delete;

  constexpr void run() {
    put_constants();
    join_products();
    list_operands();
    list_users();
    count_gains();
    for (int k = 0; k < count_; ++k) {
      if (mark_[k] != none) continue;
      if (wait_[k] == 0) offer(k);
      if (wait_[k] == 1) raise_missing_operand_of(k);
    }
    put_all();
    rearrange();
  }

private:
  using array = int[base::zeros<int>::room];
  static constexpr int none = 0, joined = 1, constant = 2, done = 3; ///< marks
  static constexpr int most_operands = 4, ranks = 2 * (most_operands + 2) + 1, of_stores = ranks - 1;

  static constexpr int store = code_of(lockstep_action::kind::value, operation::negate),
                       sum = code_of(lockstep_action::kind::value, operation::add),
                       vector_sum = code_of(lockstep_action::kind::vector, operation::add),
                       product = code_of(lockstep_action::kind::value, operation::multiply),
                       vector_product = code_of(lockstep_action::kind::vector, operation::multiply),
                       gather = code_of(lockstep_action::kind::gather, operation::constant), kept = 1 << 28;

  /// Vectors of numbers come first; they remain in memory until they are used.
  constexpr void put_constants() {
    for (int k = 0; k < count_; ++k) {
      if (action_[k] % digits != gather) continue;
      if (a_[k] >= numbers_ || b_[k] >= numbers_ || c_[k] >= numbers_ || d_[k] >= numbers_) continue;
      mark_[k] = constant;
      order_[ordered_++] = k;
    }
  }

  /// Joins products to the only sum that uses them, if it is a vector too or a number too.
  constexpr void join_products() {
    for (int k = 0; k < count_; ++k)
      for (const array* each : {&a_, &b_, &c_, &d_})
        if (const int operand = (*each)[k] - first_entry_; operand >= 0) ++use_[operand];
    for (int k = 0; k < count_; ++k) {
      const int own = action_[k] % digits;
      if (own != sum && own != vector_sum) continue;
      const int wanted = own == sum ? product : vector_product;
      for (const array* each : {&a_, &b_}) {
        const int operand = (*each)[k] - first_entry_;
        if (operand < 0 || use_[operand] != 1) continue;
        if (action_[operand] % digits != wanted || action_[operand] >= kept) continue;
        mark_[operand] = joined;
      }
    }
    for (int k = 0; k < count_; ++k) use_[k] = 0;
  }

  /// Lists the operands of every entry, including those of joined products, each value once.
  constexpr void list_operands() {
    for (int k = 0; k < count_; ++k) {
      if (mark_[k] != none) continue;
      for (const array* each : {&a_, &b_, &c_, &d_}) {
        const int operand = (*each)[k] - first_entry_;
        if (operand < 0) continue;
        if (mark_[operand] != joined) {
          add_operand(k, operand);
          continue;
        }
        add_operand(k, a_[operand] - first_entry_);
        add_operand(k, b_[operand] - first_entry_);
      }
    }
  }
  constexpr void add_operand(int k, int operand) {
    if (operand < 0 || mark_[operand] == constant) return;
    const int first = most_operands * k, end = first + operands_of_[k];
    for (int i = first; i < end; ++i)
      if (operand_[i] == operand) return;
    operand_[end] = operand;
    ++operands_of_[k];
    ++use_[operand];
    ++wait_[k];
  }

  constexpr void list_users() {
    int place = 0;
    for (int k = 0; k < count_; ++k) first_user_[k] = place += use_[k];
    first_user_[count_] = place;
    for (int k = count_ - 1; k >= 0; --k)
      for (int i = most_operands * k, end = i + operands_of_[k]; i < end; ++i)
        user_[--first_user_[operand_[i]]] = k;
  }

  /// The gain of an entry is the number of values of which it is the last use, and one more if no other entry
  /// uses its own.
  constexpr void count_gains() {
    for (int k = 0; k < count_; ++k) {
      int gain = use_[k] > 0 ? 0 : 1;
      for (int i = most_operands * k, end = i + operands_of_[k]; i < end; ++i)
        if (use_[operand_[i]] == 1) ++gain;
      gain_[k] = gain;
    }
  }

  constexpr void offer(int k) {
    const int rank = action_[k] % digits == store ? of_stores : 2 * gain_[k] + prospect_[k], word = k / 64;
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

  /// Puts the best entry that is ready, again and again, without calls, because compilers remember each.
  constexpr void put_all() {
    while (is_filled_ != 0) {
      const int best = 31 - __builtin_clz(is_filled_);
      int first_word = first_[best];
      while (ready_[best * words_ + first_word] == 0) ++first_word;
      first_[best] = first_word;
      const std::uint64_t bits = ready_[best * words_ + first_word];
      const int k = 64 * first_word + __builtin_ctzll(bits);
      ready_[best * words_ + first_word] = bits & (bits - 1);
      if (--filled_[best] == 0) is_filled_ &= ~(1U << best);
      for (int side = 0; side < 2; ++side) {
        const int operand = (side == 0 ? a_[k] : b_[k]) - first_entry_;
        if (operand < 0 || mark_[operand] != joined) continue;
        mark_[operand] = done;
        order_[ordered_++] = operand;
      }
      order_[ordered_++] = k;
      mark_[k] = done;
      for (int i = first_user_[k], end = first_user_[k + 1]; i < end; ++i) {
        const int user = user_[i], missing = --wait_[user];
        if (missing == 1 && gain_[user] > 0) raise_missing_operand_of(user);
        if (missing != 0) continue;
        const int rank = action_[user] % digits == store ? of_stores : 2 * gain_[user] + prospect_[user],
                  word = user / 64;
        rank_[user] = rank + 1;
        ready_[rank * words_ + word] |= std::uint64_t{1} << (user % 64);
        if (filled_[rank]++ == 0 || word < first_[rank]) first_[rank] = word;
        is_filled_ |= 1U << rank;
      }
      for (int i = most_operands * k, end = i + operands_of_[k]; i < end; ++i)
        if (--use_[operand_[i]] == 1) favour_last_user_of(operand_[i]);
    }
  }

  constexpr void favour_last_user_of(int of) {
    int i = first_user_[of];
    while (mark_[user_[i]] == done) ++i;
    const int user = user_[i];
    const bool is_offered = rank_[user] != 0;
    if (is_offered) withdraw(user);
    ++gain_[user];
    if (is_offered)
      offer(user);
    else if (wait_[user] == 1)
      raise_missing_operand_of(user);
  }

  /// Prefers the only operand for which an entry waits, if no value will be added.
  constexpr void raise_missing_operand_of(int k) {
    if (gain_[k] == 0) return;
    int i = most_operands * k;
    while (mark_[operand_[i]] == done) ++i;
    const int operand = operand_[i];
    if (prospect_[operand] != 0) return;
    const bool is_offered = rank_[operand] != 0;
    if (is_offered) withdraw(operand);
    prospect_[operand] = 1;
    if (is_offered) offer(operand);
  }

  constexpr void rearrange() {
    base::zeros<int> places(count_), old(count_);
    array &to = places.elements<true>(), &before = old.elements<true>();
    for (int i = 0; i < count_; ++i) to[order_[i]] = i;
    for (array* each : {&action_, &place_, &a_, &b_, &c_, &d_}) {
      const bool names_entries = each != &action_ && each != &place_;
      for (int k = 0; k < count_; ++k) before[k] = (*each)[k];
      for (int k = 0; k < count_; ++k) {
        const int value = before[k];
        (*each)[to[k]] =
            names_entries && value >= first_entry_ ? first_entry_ + to[value - first_entry_] : value;
      }
    }
  }

  lockstep_entries& entries_;
  int count_, numbers_, first_entry_, words_, ordered_ = 0;
  base::zeros<int> uses_{count_}, waits_{count_}, gains_{count_}, prospects_{count_}, ranks_{count_},
      marks_{count_}, operand_counts_{count_}, operands_{most_operands * count_}, first_users_{count_ + 1},
      users_{most_operands * count_}, orders_{count_};
  base::zeros<std::uint64_t> ready_words_{ranks * words_};
  int filled_[ranks]{}, first_[ranks]{};
  unsigned is_filled_ = 0;
  array &action_{entries_.action.elements<true>()}, &place_{entries_.place.elements<true>()},
      &a_{entries_.a.elements<true>()}, &b_{entries_.b.elements<true>()}, &c_{entries_.c.elements<true>()},
      &d_{entries_.d.elements<true>()};
  array &use_{uses_.elements<true>()}, ///< remaining uses
      &wait_{waits_.elements<true>()}, ///< operands not yet available
      &gain_{gains_.elements<true>()}, &prospect_{prospects_.elements<true>()},
      &rank_{ranks_.elements<true>()}, ///< of the entries that are ready, counted from 1
      &mark_{marks_.elements<true>()}, &operands_of_{operand_counts_.elements<true>()},
      &operand_{operands_.elements<true>()}, &first_user_{first_users_.elements<true>()},
      &user_{users_.elements<true>()}, &order_{orders_.elements<true>()};
  std::uint64_t (&ready_)[base::zeros<std::uint64_t>::room]{ready_words_.elements<true>()};
};

} // namespace kanexpr::lower::detail
