#pragma once

#include <kanexpr/base/zeros.hpp>
#include <kanexpr/lower/lockstep_entries.hpp>
#include <kanexpr/lower/value_order.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

namespace kanexpr::lower::detail {

/// What the codes of all actions with a kind and an operation have in common: their remainder.
inline constexpr int digits = 4 * 64;
constexpr int code_of(lockstep_action::kind is, operation op) {
  return lockstep_action{is, op}.code() % digits;
}

/// Orders the entries of a function in lockstep so that few values are live simultaneously (value_order).
/// Values that are only stored come at once, and products that one sum uses precede it. The code runs only in
/// constant evaluation, and accesses arrays directly.
class entry_order {
public:
  /// Operands before `first_entry` are given; the first of them are numbers.
  constexpr entry_order(lockstep_entries& entries, int numbers, int first_entry)
      : entries_(entries), numbers_(numbers), first_entry_(first_entry) {
    all_.count = entries.count;
  }
  entry_order(const entry_order&) = delete;
  entry_order& operator=(const entry_order&) = delete;

  constexpr void run() {
    put_constants_and_stores();
    join_products();
    list_operands();
    value_order<true>(all_).put_all(orders_, constants_);
    rearrange();
  }

private:
  using array = base::zeros<int>::array<true>;

  static constexpr int store = code_of(lockstep_action::kind::value, operation::negate),
                       sum = code_of(lockstep_action::kind::value, operation::add),
                       vector_sum = code_of(lockstep_action::kind::vector, operation::add),
                       product = code_of(lockstep_action::kind::value, operation::multiply),
                       vector_product = code_of(lockstep_action::kind::vector, operation::multiply),
                       gather = code_of(lockstep_action::kind::gather, operation::constant), kept = 1 << 28;

  /// Vectors of numbers come first; they remain in memory until they are used.
  constexpr void put_constants_and_stores() {
    for (int k = 0; k < all_.count; ++k) {
      const int own = action_[k] % digits;
      if (own == store) turn_[k] = turn::immediately;
      if (own != gather) continue;
      if (a_[k] >= numbers_ || b_[k] >= numbers_ || c_[k] >= numbers_ || d_[k] >= numbers_) continue;
      turn_[k] = turn::done;
      order_[constants_++] = k;
    }
  }

  /// Joins products to the only sum that uses them, if it is a vector too or a number too.
  constexpr void join_products() {
    base::zeros<int> all_uses(all_.count);
    array& uses = all_uses.elements<true>();
    for (int k = 0; k < all_.count; ++k)
      for (const array* each : {&a_, &b_, &c_, &d_})
        if (const int operand = (*each)[k] - first_entry_; operand >= 0) ++uses[operand];
    for (int k = 0; k < all_.count; ++k) {
      const int own = action_[k] % digits;
      if (own != sum && own != vector_sum) continue;
      const int wanted = own == sum ? product : vector_product;
      for (const array* each : {&a_, &b_}) {
        const int operand = (*each)[k] - first_entry_;
        if (operand < 0 || uses[operand] != 1) continue;
        if (action_[operand] % digits != wanted || action_[operand] >= kept) continue;
        turn_[operand] = turn::joined;
      }
    }
  }

  /// Lists the operands of every entry, including those of joined products.
  constexpr void list_operands() {
    array &first = all_.first_operands.elements<true>(), &operands = all_.operands.elements<true>();
    for (int k = 0; k < all_.count; ++k) {
      if (turn_[k] >= turn::joined) continue;
      for (const array* each : {&b_, &a_})
        if (const int operand = (*each)[k] - first_entry_; operand >= 0 && turn_[operand] == turn::joined)
          operands[listed_++] = unordered_values::joined(operand);
      first[k] = first_ = listed_;
      for (const array* each : {&a_, &b_, &c_, &d_}) {
        const int operand = (*each)[k] - first_entry_;
        if (operand < 0) continue;
        if (turn_[operand] != turn::joined) {
          add_operand(operand);
          continue;
        }
        add_operand(a_[operand] - first_entry_);
        add_operand(b_[operand] - first_entry_);
      }
      operands[listed_++] = unordered_values::end;
    }
  }
  constexpr void add_operand(int operand) {
    if (operand < 0 || turn_[operand] == turn::done) return;
    array& operands = all_.operands.elements<true>();
    for (int i = first_; i < listed_; ++i)
      if (operands[i] == operand) return;
    operands[listed_++] = operand;
  }

  constexpr void rearrange() {
    base::zeros<int> places(all_.count), old(all_.count);
    array &to = places.elements<true>(), &before = old.elements<true>();
    for (int i = 0; i < all_.count; ++i) to[order_[i]] = i;
    for (array* each : {&action_, &place_, &a_, &b_, &c_, &d_}) {
      const bool names_entries = each != &action_ && each != &place_;
      for (int k = 0; k < all_.count; ++k) before[k] = (*each)[k];
      for (int k = 0; k < all_.count; ++k) {
        const int value = before[k];
        (*each)[to[k]] =
            names_entries && value >= first_entry_ ? first_entry_ + to[value - first_entry_] : value;
      }
    }
  }

  lockstep_entries& entries_;
  int numbers_, first_entry_, constants_ = 0;
  int listed_ = 1, first_ = 0; ///< of the operands: where the next one comes, and the first one of an entry
  unordered_values all_{entries_.count, 4 * entries_.count};
  base::zeros<int> orders_{entries_.count};
  array &order_{orders_.elements<true>()}, &action_{entries_.action.elements<true>()},
      &place_{entries_.place.elements<true>()}, &a_{entries_.a.elements<true>()},
      &b_{entries_.b.elements<true>()}, &c_{entries_.c.elements<true>()}, &d_{entries_.d.elements<true>()};
  base::zeros<turn>::array<true>& turn_{all_.turns.elements<true>()};
};

} // namespace kanexpr::lower::detail
