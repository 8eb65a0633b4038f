#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/base/zeros.hpp>
#include <kanexpr/lower/entry_order.hpp>
#include <kanexpr/lower/equal_branches.hpp>
#include <kanexpr/lower/fixed_tape.hpp>
#include <kanexpr/lower/lockstep.hpp>
#include <kanexpr/lower/lockstep_entries.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

#include <cstddef>

namespace kanexpr::lower {

namespace detail {

/// Orders the steps before `end` and the bundles: each follows its operands, and otherwise the order of the
/// tape is kept. A bundle comes when its first step is needed. The code runs only in constant evaluation.
template <class Tape, class Places>
class lockstep_order {
public:
  /// `place` has the place in memory of each slot, -1 if the value is not stored.
  constexpr lockstep_order(const Tape& t, const lockstep& l, int given, int end, const Places& place)
      : tape_(t), l_(l), lanes_(l.lanes), numbers_(t.sizes.numbers), first_(t.first_step()), given_(given),
        slots_(first_ + end), tasks_(slots_ + l.count()), place_(place), out_(3 * slots_) {}
  lockstep_order(const lockstep_order&) = delete;
  lockstep_order& operator=(const lockstep_order&) = delete;

  constexpr lockstep_entries run() {
    for (int task = 0; task < tasks_; ++task) entry_[task] = none;
    place_given();
    find_tasks();
    for (int slot = first_ + given_; slot < slots_; ++slot) {
      const bool is_sign = op_[slot - first_] == operation::negate;
      if (is_sign && place_[slot] == none) continue;
      const int task = task_[is_sign ? root_[slot] : slot];
      if (entry_[task] == none) complete(task);
      if (is_sign) keep(slot);
    }
    return static_cast<lockstep_entries&&>(out_);
  }

private:
  static constexpr int none = -1;
  using kind = lockstep_action::kind;

  /// Whether the lanes of a bundle are computed apart: arguments, what is given, and functions.
  constexpr bool is_apart(int slot) const {
    return slot < first_ + given_ || op_[slot - first_] > operation::divide;
  }

  constexpr void place_given() {
    for (int i = 0; i < numbers_; ++i) entry_[i] = i;
    sequence<char> is_early(tape_.sizes.loads + 1, 0);
    for (int i = 0; i < given_; ++i) {
      for (int slot : {tape_.a[i], tape_.b[i]})
        if (slot >= numbers_ && slot < first_) is_early[slot - numbers_] = 1;
    }
    for (int i = 0; i < tape_.sizes.loads; ++i) {
      if (is_early[i] == 0) continue;
      entry_[numbers_ + i] = numbers_ + out_.early.size();
      out_.early.push(i);
    }
    first_entry_ = numbers_ + out_.early.size() + given_;
    for (int i = 0; i < given_; ++i) entry_[first_ + i] = numbers_ + out_.early.size() + i;
  }

  /// A task is a slot that has an entry of its own, or a bundle, counted from the number of slots.
  constexpr void find_tasks() {
    const auto& op = op_;
    const auto& bundle = bundle_;
    auto& task = task_;
    for (int slot = 0; slot < slots_; ++slot) {
      const bool is_own =
          bundle[slot] == 0 || slot < first_ + given_ || op[slot - first_] > operation::divide;
      task[slot] = is_own ? slot : slots_ + bundle[slot] - 1;
    }
  }

  constexpr void complete(int wanted) {
    open_[open_count_++] = wanted;
    while (open_count_ != 0) {
      const int task = open_[open_count_ - 1], before = open_count_;
      if (entry_[task] == none && task >= first_) {
        if (task < slots_) {
          need(task_[a_[task]]);
          need(task_[b_[task]]);
        } else {
          push_operands(task - slots_);
        }
      }
      if (open_count_ != before) continue;
      --open_count_;
      if (entry_[task] != none) continue;
      if (task < slots_)
        add_scalar(task);
      else
        add_bundle(task - slots_);
    }
  }

  constexpr void need(int task) {
    if (entry_[task] == none) open_[open_count_++] = task;
  }

  constexpr void push_operands(int bundle) {
    const int* const members = members_of(bundle);
    if (is_apart(members[0])) {
      for (int k = 0; k < lanes_; ++k) need(members[k]);
      return;
    }
    const int a = a_[members[0]], b = b_[members[0]];
    const bool whole_a = is_whole(a, a_[members[1]]), whole_b = is_whole(b, b_[members[1]]);
    if (whole_a) need(slots_ + bundle_[a] - 1);
    if (whole_b) need(slots_ + bundle_[b] - 1);
    for (int k = 0; k < lanes_; ++k) {
      const int member = members[k];
      if (!whole_a) need(task_[a_[member]]);
      if (!whole_b) need(task_[b_[member]]);
    }
  }

  /// Whether an operand of a bundle is another bundle.
  constexpr bool is_whole(int slot, int next) const {
    const int bundle = bundle_[slot];
    return bundle != 0 && lane_[slot] == 0 && l_.members.begin()[(bundle - 1) * lanes_ + 1] == next;
  }

  constexpr const int* members_of(int bundle) const {
    const int first = bundle * lanes_;
    return l_.members.begin() + first;
  }

  constexpr int add(const lockstep_action& action, int a, int b = 0, int c = 0, int d = 0, int place = 0) {
    const int entry = out_.count++;
    to_action_[entry] = action.code();
    to_place_[entry] = place;
    to_a_[entry] = a, to_b_[entry] = b, to_c_[entry] = c, to_d_[entry] = d;
    return first_entry_ + entry;
  }

  struct operand {
    int entry = 0;
    operand_form form{};
  };
  constexpr operand scalar(int slot, bool minus) const {
    if (entry_[slot] != none) return {entry_[slot], {operand_form::scalar, minus}};
    return {entry_[slots_ + bundle_[slot] - 1], {lane_[slot], minus != (minus_[slot] != 0)}};
  }
  constexpr operation op_of(int slot) const {
    const operation op = op_[slot - first_];
    return op == operation::subtract ? operation::add : op;
  }

  constexpr void add_scalar(int slot) {
    if (slot < first_) {
      entry_[slot] = add({kind::argument}, 0, 0, 0, 0, place_[slot]);
      return;
    }
    const operand a = scalar(a_[slot], minus_a_[slot] != 0), b = scalar(b_[slot], minus_b_[slot] != 0);
    const int place = place_[slot];
    const bool is_kept = place != none;
    entry_[slot] = add({kind::value, op_of(slot), a.form, b.form, 0, 0, is_kept}, a.entry, b.entry, 0, 0,
                       is_kept ? place : 0);
    ++out_.operations;
  }

  /// Stores a value that is the root of a slot or minus that.
  constexpr void keep(int slot) {
    const operand a = scalar(root_[slot], negated_[slot] != 0);
    add({kind::value, operation::negate, {a.form.lane, !a.form.is_minus}, {}, 0, 0, true}, a.entry, 0, 0, 0,
        place_[slot]);
  }

  constexpr void add_bundle(int bundle) {
    const int* const members = members_of(bundle);
    const int task = slots_ + bundle;
    if (is_apart(members[0])) {
      int minus = 0;
      for (int k = 0; k < lanes_; ++k) minus |= minus_[members[k]] << k;
      entry_[task] = gather(members, minus);
      return;
    }
    const operation op = op_of(members[0]);
    int first[4]{}, second[4]{}, minus_a = 0, minus_b = 0;
    for (int k = 0; k < lanes_; ++k) first[k] = a_[members[k]], second[k] = b_[members[k]];
    const bool whole_a = is_whole(first[0], first[1]), whole_b = is_whole(second[0], second[1]);
    const bool second_is_gathered = op != operation::add && is_gathered(second);
    for (int k = 0; k < lanes_; ++k) {
      const int member = members[k];
      const bool all = minus_[member] != 0, a = (minus_a_[member] != 0) != (whole_a && minus_[first[k]] != 0),
                 b = (minus_b_[member] != 0) != (whole_b && minus_[second[k]] != 0);
      if (op == operation::add) {
        minus_a |= (a != all ? 1 : 0) << k;
        minus_b |= (b != all ? 1 : 0) << k;
      } else {
        (second_is_gathered ? minus_b : minus_a) |= ((a != b) != all ? 1 : 0) << k;
      }
    }
    const operand a = vector_operand(first, minus_a), b = vector_operand(second, minus_b);
    const int entry = add({kind::vector, op, a.form, b.form, minus_a, minus_b, false}, a.entry, b.entry);
    entry_[task] = entry;
    ++out_.operations;
    ++out_.vector_operations;
    for (int k = 0; k < lanes_; ++k) {
      const int member = members[k], place = place_[member];
      if (place != none)
        add({kind::value, operation::negate, {k, minus_[member] == 0}, {}, 0, 0, true}, entry, 0, 0, 0,
            place);
    }
  }

  /// Whether an operand is neither another bundle nor the same value in all lanes.
  constexpr bool is_gathered(const int* operands) const {
    if (is_whole(operands[0], operands[1])) return false;
    bool is_same = operands[0] >= numbers_;
    for (int k = 1; k < lanes_; ++k) is_same = is_same && operands[k] == operands[0];
    return !is_same;
  }

  /// What is gathered takes its signs with it.
  constexpr operand vector_operand(const int* operands, int& minus) {
    if (is_whole(operands[0], operands[1]))
      return {entry_[slots_ + bundle_[operands[0]] - 1], {operand_form::whole}};
    if (!is_gathered(operands)) {
      const operand same = scalar(operands[0], false);
      if (same.form.is_minus) minus ^= (1 << lanes_) - 1;
      return {same.entry, {same.form.lane}};
    }
    const int gathered = gather(operands, minus);
    minus = 0;
    return {gathered, {operand_form::whole}};
  }

  constexpr int gather(const int* operands, int minus) {
    int all[4]{};
    for (int k = 0; k < lanes_; ++k) all[k] = entry_[operands[k]];
    return add({kind::gather, operation::constant, {}, {}, minus, 0, false}, all[0], all[1], all[2], all[3]);
  }

  const Tape& tape_;
  const lockstep& l_;
  int lanes_, numbers_, first_, given_, slots_, tasks_, first_entry_ = 0, open_count_ = 0;
  const Places& place_;
  lockstep_entries out_;
  base::zeros<int> entries_{tasks_}, tasks_of_slots_{slots_}, stack_{8 * tasks_};
  const decltype(Tape::op)& op_{tape_.op};
  const base::zeros<int>::array<true>&root_{l_.root.elements<true>()}, &a_{l_.a.elements<true>()},
      &b_{l_.b.elements<true>()}, &bundle_{l_.bundles.elements<true>()};
  const base::zeros<char>::array<true>&lane_{l_.lane.elements<true>()}, &minus_{l_.minus.elements<true>()},
      &minus_a_{l_.minus_a.elements<true>()}, &minus_b_{l_.minus_b.elements<true>()},
      &negated_{l_.negated.elements<true>()};
  base::zeros<int>::array<true>&entry_{entries_.elements<true>()}, &task_{tasks_of_slots_.elements<true>()},
      &open_{stack_.elements<true>()}, &to_action_{out_.action.elements<true>()},
      &to_place_{out_.place.elements<true>()}, &to_a_{out_.a.elements<true>()},
      &to_b_{out_.b.elements<true>()}, &to_c_{out_.c.elements<true>()}, &to_d_{out_.d.elements<true>()};
};

} // namespace detail

/// The steps before the first symmetric system, with equal branches in lockstep. `Cuts` is the type whose
/// constant `value` has the places in memory.
template <class Code, class Cuts, int most_lanes>
class lockstep_plan {
  static constexpr const auto& tape = Code::tape;
  static constexpr int given = tape.sizes.first_angle + 2 * tape.sizes.angles;
  static constexpr std::size_t room =
      static_cast<std::size_t>(3 * tape.slot_count()); // with stored lanes and gathered operands

  struct arrays {
    int lanes = 0; ///< 0 if nothing runs in lockstep
    int entries = 0, early_count = 0;
    int operations = 0, vector_operations = 0;
    int early[room]{}, action[room]{}, place[room]{}, a[room]{}, b[room]{}, c[room]{}, d[room]{};

    constexpr arrays() {
      const tape_view view(tape);
      const int end = Cuts::value.first[1];
      if (!is_possible(end)) return;
      const equal_branches branches = equal_branches_of(view, most_lanes);
      if (branches.count == 0) return;
      const lockstep found = detail::lockstep_search(tape, branches, end).run();
      if (4 * found.count() * (found.lanes - 1) < end) return; // too few to pay
      lockstep_entries all = detail::lockstep_order(tape, found, given, end, Cuts::value.place).run();
      detail::entry_order(all, tape.sizes.numbers, tape.sizes.numbers + all.early.size() + given).run();
      lanes = found.lanes, entries = all.count, early_count = all.early.size();
      operations = all.operations, vector_operations = all.vector_operations;
      for (int i = 0; i < early_count; ++i) early[i] = all.early[i];
      copy(all.action, action), copy(all.place, place);
      copy(all.a, a), copy(all.b, b), copy(all.c, c), copy(all.d, d);
    }

    /// Steps that fill several slots are not provided for.
    static constexpr bool is_possible(int end) {
      if (Cuts::value.pieces < 2 || Cuts::value.solves[0] >= 0 || Cuts::value.solves[1] < 0) return false;
      for (int i = 0; i < tape.sizes.linear_steps; ++i)
        if (tape.linear_steps[i].step < end) return false;
      for (int i = given; i < end; ++i)
        if (tape.paired[i]) return false;
      return true;
    }
    constexpr void copy(const base::zeros<int>& from, int (&to)[room]) const {
      const auto& each = from.elements<true>();
      for (int i = 0; i < entries; ++i) to[i] = each[i];
    }
  };

public:
  static constexpr arrays value{};
};

} // namespace kanexpr::lower
