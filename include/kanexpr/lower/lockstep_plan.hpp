#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/base/zeros.hpp>
#include <kanexpr/lower/equal_branches.hpp>
#include <kanexpr/lower/fixed_tape.hpp>
#include <kanexpr/lower/lockstep.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

#include <cstddef>

namespace kanexpr::lower {

/// How an operand is read: one lane of a vector, a scalar, or all lanes; a scalar is the same in all lanes.
struct operand_form {
  int lane = scalar;
  bool is_minus = false;

  static constexpr int scalar = 4, whole = 5;
};

/// What fills an entry, encoded as a number, so that all entries with the same action share one function.
struct lockstep_action {
  enum class kind { argument, value, vector, gather };

  kind is = kind::argument;
  operation op = operation::constant; ///< a change of sign denotes a value that is only stored
  operand_form a{}, b{};
  int minus_a = 0, minus_b = 0; ///< of a vector: the lanes in which an operand changes its sign
  bool is_kept = false;         ///< whether the value is stored in memory

  constexpr int code() const {
    const int forms = a.lane + 8 * b.lane + 64 * (a.is_minus ? 1 : 0) + 128 * (b.is_minus ? 1 : 0);
    return static_cast<int>(is) + 4 * (static_cast<int>(op) + 64 * (forms + 256 * (minus_a + 16 * minus_b))) +
           (is_kept ? 1 << 28 : 0);
  }
  static constexpr lockstep_action of(int code) {
    const auto next = [&](int values) {
      const int value = code % values;
      code /= values;
      return value;
    };
    lockstep_action read;
    read.is = static_cast<kind>(next(4));
    read.op = static_cast<operation>(next(64));
    read.a.lane = next(8), read.b.lane = next(8);
    read.a.is_minus = next(2) != 0, read.b.is_minus = next(2) != 0;
    read.minus_a = next(16), read.minus_b = next(16);
    read.is_kept = code != 0;
    return read;
  }
};

/// The entries of a function that evaluates bundles of steps in lockstep and the other steps one by one. The
/// numbers, the early arguments, the first steps and the angles precede them.
struct lockstep_entries {
  sequence<int> early{};                     ///< the arguments that the first steps need
  sequence<int> action{}, place{};           ///< of each entry; places in memory
  sequence<int> a{}, b{}, c{}, d{};          ///< the entries of the operands; a gathered vector has four
  int operations = 0, vector_operations = 0; ///< how many entries are operations, and how many of all lanes
};

namespace detail {

/// Orders the steps before `end` and the bundles: each follows its operands, and otherwise the order of the
/// tape is kept. A bundle comes when its first step is needed.
class lockstep_order {
public:
  /// `place` has the place in memory of each slot, -1 if the value is not stored.
  constexpr lockstep_order(const tape_view& t, const lockstep& l, int given, int end, const int* place)
      : tape_(t), l_(l), numbers_(t.numbers.size()), first_(t.first_step()), given_(given), end_(end),
        place_(place), entry_of_(first_ + end, none), entry_of_bundle_(l.count() + 1, none) {}
  lockstep_order(const lockstep_order&) = delete;
  lockstep_order& operator=(const lockstep_order&) = delete;

  constexpr lockstep_entries run() {
    place_given();
    for (int slot = first_ + given_; slot < first_ + end_; ++slot) {
      const bool is_sign = op_of(slot) == operation::negate;
      if (is_sign && place_[slot] == none) continue;
      complete(is_sign ? task_of(l_.root[slot]) : task_of(slot));
      if (is_sign) keep(slot);
    }
    return static_cast<lockstep_entries&&>(out_);
  }

private:
  static constexpr int none = -1;
  using kind = lockstep_action::kind;

  constexpr operation op_of(int slot) const { return tape_.steps.op[slot - first_]; }
  /// Whether the lanes of a bundle are computed apart: arguments, what is given, and functions.
  constexpr bool is_apart(int slot) const {
    return slot < first_ + given_ || op_of(slot) > operation::divide;
  }

  constexpr void place_given() {
    for (int i = 0; i < numbers_; ++i) entry_of_[i] = i;
    sequence<char> is_early(tape_.loads.size() + 1, 0);
    for (int i = 0; i < given_; ++i) {
      for (int slot : {tape_.steps.a[i], tape_.steps.b[i]})
        if (slot >= numbers_ && slot < first_) is_early[slot - numbers_] = 1;
    }
    for (int i = 0; i < tape_.loads.size(); ++i) {
      if (is_early[i] == 0) continue;
      entry_of_[numbers_ + i] = numbers_ + out_.early.size();
      out_.early.push(i);
    }
    first_entry_ = numbers_ + out_.early.size() + given_;
    for (int i = 0; i < given_; ++i) entry_of_[first_ + i] = numbers_ + out_.early.size() + i;
  }

  // A task is a slot that has an entry of its own, or a bundle, counted from the number of slots.

  constexpr int task_of(int slot) const {
    return is_apart(slot) || l_.bundles[slot] == 0 ? slot : task_of_bundle(slot);
  }
  constexpr int task_of_bundle(int slot) const { return first_ + end_ + l_.bundles[slot] - 1; }
  constexpr bool is_done(int task) const {
    return task < first_ + end_ ? entry_of_[task] != none : entry_of_bundle_[task - first_ - end_] != none;
  }

  constexpr void complete(int wanted) {
    sequence<int> open{wanted};
    while (!open.empty()) {
      const int task = open.back(), before = open.size();
      if (!is_done(task)) push_operands(task, open);
      if (open.size() != before) continue;
      open.pop();
      if (is_done(task)) continue;
      if (task < first_ + end_)
        add_scalar(task);
      else
        add_bundle(task - first_ - end_);
    }
  }

  constexpr void push_operands(int task, sequence<int>& open) const {
    const auto need = [&](int other) {
      if (!is_done(other)) open.push(other);
    };
    if (task < first_) return;
    if (task < first_ + end_) {
      const signed_step s = l_.step_of(tape_, task);
      need(task_of(s.a));
      need(task_of(s.b));
      return;
    }
    const int* const members = members_of(task - first_ - end_);
    if (is_apart(members[0])) {
      for (int k = 0; k < l_.lanes; ++k) need(members[k]);
      return;
    }
    const signed_step s = l_.step_of(tape_, members[0]), next = l_.step_of(tape_, members[1]);
    if (is_whole(s.a, next.a)) need(task_of_bundle(s.a));
    if (is_whole(s.b, next.b)) need(task_of_bundle(s.b));
    for (int k = 0; k < l_.lanes; ++k) {
      const signed_step each = l_.step_of(tape_, members[k]);
      if (!is_whole(s.a, next.a)) need(task_of(each.a));
      if (!is_whole(s.b, next.b)) need(task_of(each.b));
    }
  }

  /// Whether an operand of a bundle is another bundle.
  constexpr bool is_whole(int slot, int next) const {
    const int bundle = l_.bundles[slot];
    return bundle != 0 && l_.lane[slot] == 0 && l_.members[(bundle - 1) * l_.lanes + 1] == next;
  }

  constexpr const int* members_of(int bundle) const {
    const int first = bundle * l_.lanes;
    return l_.members.begin() + first;
  }

  constexpr int add(const lockstep_action& action, int a, int b = 0, int c = 0, int d = 0, int place = 0) {
    out_.place.push(place);
    out_.a.push(a), out_.b.push(b), out_.c.push(c), out_.d.push(d);
    return first_entry_ + out_.action.push(action.code());
  }

  struct operand {
    int entry = 0;
    operand_form form{};
  };
  constexpr operand scalar(int slot, bool minus) const {
    if (entry_of_[slot] != none) return {entry_of_[slot], {operand_form::scalar, minus}};
    return {entry_of_bundle_[l_.bundles[slot] - 1], {l_.lane[slot], minus != (l_.minus[slot] != 0)}};
  }

  constexpr void add_scalar(int slot) {
    if (slot < first_) {
      entry_of_[slot] = add({kind::argument}, 0, 0, 0, 0, place_[slot]);
      return;
    }
    const signed_step s = l_.step_of(tape_, slot);
    const operand a = scalar(s.a, s.minus_a), b = scalar(s.b, s.minus_b);
    const bool is_kept = place_[slot] != none;
    entry_of_[slot] = add({kind::value, s.op, a.form, b.form, 0, 0, is_kept}, a.entry, b.entry, 0, 0,
                          is_kept ? place_[slot] : 0);
    ++out_.operations;
  }

  /// Stores a value that is the root of a slot or minus that.
  constexpr void keep(int slot) {
    const operand a = scalar(l_.root[slot], l_.negated[slot] != 0);
    add({kind::value, operation::negate, {a.form.lane, !a.form.is_minus}, {}, 0, 0, true}, a.entry, 0, 0, 0,
        place_[slot]);
  }

  constexpr void add_bundle(int bundle) {
    const int* const members = members_of(bundle);
    if (is_apart(members[0])) {
      int minus = 0;
      for (int k = 0; k < l_.lanes; ++k) minus |= l_.minus[members[k]] << k;
      entry_of_bundle_[bundle] = gather(members, minus);
      return;
    }
    signed_step s[4];
    int first[4]{}, second[4]{}, minus_a = 0, minus_b = 0;
    for (int k = 0; k < l_.lanes; ++k) {
      s[k] = l_.step_of(tape_, members[k]);
      first[k] = s[k].a, second[k] = s[k].b;
    }
    const bool whole_a = is_whole(first[0], first[1]), whole_b = is_whole(second[0], second[1]);
    for (int k = 0; k < l_.lanes; ++k) {
      const bool all = l_.minus[members[k]] != 0, a = s[k].minus_a != (whole_a && l_.minus[first[k]] != 0),
                 b = s[k].minus_b != (whole_b && l_.minus[second[k]] != 0);
      if (s[0].op == operation::add) {
        minus_a |= (a != all ? 1 : 0) << k;
        minus_b |= (b != all ? 1 : 0) << k;
      } else {
        (is_gathered(second) ? minus_b : minus_a) |= ((a != b) != all ? 1 : 0) << k;
      }
    }
    const operand a = vector_operand(first, minus_a), b = vector_operand(second, minus_b);
    entry_of_bundle_[bundle] =
        add({kind::vector, s[0].op, a.form, b.form, minus_a, minus_b, false}, a.entry, b.entry);
    ++out_.operations;
    ++out_.vector_operations;
    for (int k = 0; k < l_.lanes; ++k)
      if (place_[members[k]] != none)
        add({kind::value, operation::negate, {k, l_.minus[members[k]] == 0}, {}, 0, 0, true},
            entry_of_bundle_[bundle], 0, 0, 0, place_[members[k]]);
  }

  /// Whether an operand is neither another bundle nor the same value in all lanes.
  constexpr bool is_gathered(const int* operands) const {
    if (is_whole(operands[0], operands[1])) return false;
    bool is_same = operands[0] >= numbers_;
    for (int k = 1; k < l_.lanes; ++k) is_same = is_same && operands[k] == operands[0];
    return !is_same;
  }

  /// What is gathered takes its signs with it.
  constexpr operand vector_operand(const int* operands, int& minus) {
    if (is_whole(operands[0], operands[1]))
      return {entry_of_bundle_[l_.bundles[operands[0]] - 1], {operand_form::whole}};
    if (!is_gathered(operands)) {
      const operand same = scalar(operands[0], false);
      if (same.form.is_minus) minus ^= (1 << l_.lanes) - 1;
      return {same.entry, {same.form.lane}};
    }
    const int gathered = gather(operands, minus);
    minus = 0;
    return {gathered, {operand_form::whole}};
  }

  constexpr int gather(const int* operands, int minus) {
    int all[4]{};
    for (int k = 0; k < l_.lanes; ++k) all[k] = entry_of_[operands[k]];
    return add({kind::gather, operation::constant, {}, {}, minus, 0, false}, all[0], all[1], all[2], all[3]);
  }

  const tape_view& tape_;
  const lockstep& l_;
  int numbers_, first_, given_, end_, first_entry_ = 0;
  const int* place_;
  sequence<int> entry_of_, entry_of_bundle_;
  lockstep_entries out_{};
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
      const lockstep found = detail::lockstep_search(view, branches, end).run();
      if (4 * found.count() * (found.lanes - 1) < end) return; // too few to pay
      const lockstep_entries all = detail::lockstep_order(view, found, given, end, Cuts::value.place).run();
      lanes = found.lanes, entries = all.action.size(), early_count = all.early.size();
      operations = all.operations, vector_operations = all.vector_operations;
      copy(all.early, early), copy(all.action, action), copy(all.place, place);
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
    static constexpr void copy(const sequence<int>& from, int* to) {
      const int* const each = from.begin();
      for (int i = 0, end = from.size(); i < end; ++i) to[i] = each[i];
    }
  };

public:
  static constexpr arrays value{};
};

} // namespace kanexpr::lower
