#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/base/zeros.hpp>
#include <kanexpr/lower/equal_branches.hpp>
#include <kanexpr/lower/fixed_tape.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

namespace kanexpr::lower {

/// A step whose operands no change of sign fills: op(±a, ±b). A difference is a sum.
struct signed_step {
  operation op = operation::constant;
  int a = 0, b = 0; ///< slots; an operation with one operand names it twice
  bool minus_a = false, minus_b = false;
};

/// Bundles of steps of a tape, each of which is the same operation for each of several equal branches. The
/// values of a bundle are the lanes of a vector. They are the values of the steps up to their signs, so that
/// branches that are mirror images of each other run in lockstep too; changes of sign do not round.
struct lockstep {
  int lanes = 0;
  sequence<int> members{};  ///< slots: for each bundle, one of each lane
  base::zeros<int> bundles; ///< of each slot, counted from 1; 0 for none
  base::zeros<char> lane;   ///< of each slot in a bundle
  base::zeros<char> minus;  ///< whether the value in the bundle is minus that of the step

  base::zeros<int> root;     ///< of each slot, the slot without the changes of sign before it
  base::zeros<char> negated; ///< whether a slot is minus its root
  /// The operands of each slot in the order of its bundle, without signs, and their signs.
  base::zeros<int> a, b;
  base::zeros<char> minus_a, minus_b;

  constexpr lockstep(int branches, int slots)
      : lanes(branches), bundles(slots), lane(slots), minus(slots), root(slots), negated(slots), a(slots),
        b(slots), minus_a(slots), minus_b(slots) {}
  constexpr int count() const { return lanes == 0 ? 0 : members.size() / lanes; }
};

namespace detail {

/// Finds the steps that have the same operands in each of several equal branches, beginning with their
/// arguments. Operands outside the branches may differ, as numbers do, but are the same if possible.
///
/// No bundle depends on itself: each of its steps depends on the same lane of other bundles, on values that
/// all lanes share, and on values from outside, so that a circle of bundles would be a circle of steps. The
/// code runs only in constant evaluation, and accesses arrays directly because compilers interpret every
/// call.
template <class Tape>
class lockstep_search {
public:
  /// Only the steps before `end` are examined.
  constexpr lockstep_search(const Tape& t, const equal_branches& branches, int end)
      : tape_(t), numbers_(t.sizes.numbers), first_(t.first_step()), end_(end), lanes_(branches.count),
        found_(lanes_, first_ + end) {
    for (int first = 0; first < branches.arguments.size(); first += lanes_)
      add_bundle(branches.arguments.begin() + first);
  }
  lockstep_search(const lockstep_search&) = delete;
  lockstep_search& operator=(const lockstep_search&) = delete;

  constexpr lockstep run() {
    find_operands();
    list_users();
    for (int slot = first_; slot < first_ + end_; ++slot) {
      if (bundle_[slot] != 0) continue;
      const operation op = op_[slot - first_];
      if (op >= operation::add && op <= operation::divide)
        match(slot, true);
      else if (symbolic::is_function(op) && !symbolic::is_binary(op))
        match(slot, false);
    }
    return static_cast<lockstep&&>(found_);
  }

private:
  static constexpr int none = -1, any_number = -2, any_input = -3, most_lanes = 4;
  /// How well a step corresponds: another one may be better than a value from outside in its lane, or than a
  /// change of sign that requires a product.
  enum fit { different, second_choice, equal };

  constexpr void find_operands() {
    const auto &a = tape_.a, &b = tape_.b;
    auto& negated = negated_;
    for (int slot = 0; slot < first_; ++slot) {
      root_[slot] = slot;
      if (bundle_[slot] != 0 || is_input(slot)) inside_[slot] = 1;
    }
    for (int i = 0, slot = first_; i < end_; ++i, ++slot) {
      const operation op = op_[i];
      const bool has_two = op <= operation::divide ? op != operation::negate : symbolic::is_binary(op);
      const int left = a[i], right = has_two ? b[i] : left;
      if (op == operation::negate) {
        root_[slot] = root_[left];
        if (negated[left] == 0) negated[slot] = 1;
      } else {
        root_[slot] = slot;
      }
      if (inside_[left] != 0 || inside_[right] != 0) inside_[slot] = 1;
      a_[slot] = root_[left];
      b_[slot] = root_[right];
      if (negated[left] != 0) minus_a_[slot] = 1;
      if ((negated[right] != 0) != (op == operation::subtract)) minus_b_[slot] = 1;
    }
  }

  /// Lists the steps that use each slot, up to sign.
  constexpr void list_users() {
    auto& first = first_user_; // of the slot before
    const int end = first_ + end_;
    for (int slot = 0; slot <= end; ++slot) first[slot] = 0;
    for (int slot = first_; slot < end; ++slot) {
      if (op_[slot - first_] == operation::negate) continue;
      ++first[a_[slot] + 1];
      if (b_[slot] != a_[slot]) ++first[b_[slot] + 1];
    }
    int sum = 0;
    for (int slot = 0; slot < end; ++slot) {
      const int count = first[slot + 1];
      first[slot + 1] = sum;
      sum += count;
    }
    for (int slot = first_; slot < end; ++slot) { // afterwards, `first` is behind the users of a slot
      if (op_[slot - first_] == operation::negate) continue;
      user_[first[a_[slot] + 1]++] = slot;
      if (b_[slot] != a_[slot]) user_[first[b_[slot] + 1]++] = slot;
    }
  }

  /// Bundles a step with its counterparts in the other lanes, if there is one in each.
  constexpr void match(int slot, bool has_two) {
    const int a = a_[slot], b = b_[slot];
    if (lane_[a] != 0 || lane_[b] != 0 || (bundle_[a] == 0 && bundle_[b] == 0)) return;
    const bool by_b = bundle_[a] == 0 || (bundle_[b] != 0 && first_user_[b + 1] - first_user_[b] <
                                                                 first_user_[a + 1] - first_user_[a]);
    const int first_anchor = (bundle_[by_b ? b : a] - 1) * lanes_;
    const int* const anchors = found_.members.begin() + first_anchor;
    int all[most_lanes]{slot};
    bool exchanged[most_lanes]{};
    for (int k = 1; k < lanes_; ++k) {
      all[k] = counterpart(slot, has_two, anchors[k], k, exchanged[k]);
      if (all[k] == none) return;
      for (int other = 0; other < k; ++other)
        if (all[other] == all[k]) return;
    }
    for (int k = 1; k < lanes_; ++k) accept(slot, has_two, all[k], exchanged[k]);
    bundle_inputs(a, all, a_);
    bundle_inputs(b, all, b_);
    add_bundle(all);
  }

  /// What an operand of the first lane is in another one.
  constexpr int wanted(int operand, int k) const {
    if (operand < numbers_) return any_number;
    if (bundle_[operand] != 0) return found_.members[(bundle_[operand] - 1) * lanes_ + k];
    return is_input(operand) ? any_input : operand;
  }
  constexpr bool is_input(int slot) const {
    return slot >= numbers_ && slot < first_ &&
           tape_.loads[slot - numbers_].from == symbolic::symbol_kind::input;
  }
  constexpr bool is_any(int which, int slot) const {
    if (which == any_number) return slot < numbers_;
    if (which == any_input) return is_input(slot) && bundle_[slot] == 0;
    return inside_[which] == 0 && slot >= numbers_ && inside_[slot] == 0;
  }

  /// Among the users of the anchor, the one whose operands correspond best.
  constexpr int counterpart(int slot, bool has_two, int anchor, int k, bool& exchanged) const {
    const int a = wanted(a_[slot], k), b = wanted(b_[slot], k);
    const operation op = op_[slot - first_];
    const bool is_sum = op == operation::add || op == operation::subtract;
    int second = none;
    for (int at = first_user_[anchor], end = first_user_[anchor + 1]; at < end; ++at) {
      const int other = user_[at];
      if (bundle_[other] != 0) continue;
      const operation of_other = op_[other - first_];
      if (of_other != op && (!is_sum || (of_other != operation::add && of_other != operation::subtract)))
        continue;
      const int left = a_[other], right = b_[other];
      for (int turn = 0; turn < (has_two && op != operation::divide ? 2 : 1); ++turn) {
        const int x = turn == 0 ? left : right, y = turn == 0 ? right : left;
        if ((a != x && !is_any(a, x)) || (b != y && !is_any(b, y))) continue;
        const bool minus_x = (turn == 0 ? minus_a_ : minus_b_)[other] != 0,
                   minus_y = (turn == 0 ? minus_b_ : minus_a_)[other] != 0;
        const fit how = fit_of(slot, has_two, is_sum, x, y, minus_x, minus_y);
        if (how == different || (how == second_choice && second != none)) continue;
        exchanged = turn == 1;
        if (how == equal) return other;
        second = other;
      }
    }
    return second;
  }

  /// Functions of negative angles remain outside. Otherwise any factor, number or value from outside may have
  /// any sign, and the signs of both terms should differ from those of the first lane, or none.
  constexpr fit fit_of(int slot, bool has_two, bool is_sum, int a, int b, bool minus_a, bool minus_b) const {
    if (!has_two) return changes_sign(a_[slot], minus_a_[slot] != 0, a, minus_a) ? different : equal;
    if (differs(a_[slot], a) || differs(b_[slot], b)) return second_choice;
    if (!is_sum || a_[slot] < numbers_ || b_[slot] < numbers_) return equal;
    return changes_sign(a_[slot], minus_a_[slot] != 0, a, minus_a) ==
                   changes_sign(b_[slot], minus_b_[slot] != 0, b, minus_b)
               ? equal
               : second_choice;
  }
  /// Whether a number or a value from outside is not the same in both lanes, except for the sign of a number.
  constexpr bool differs(int own, int other) const {
    if (own >= numbers_) return is_from_outside(own, other);
    const symbolic::number &x = tape_.numbers[own], &y = tape_.numbers[other];
    return own != other && !(x == y) && !(x == -y);
  }
  constexpr bool is_from_outside(int own, int other) const {
    return own != other && own >= numbers_ && inside_[own] == 0;
  }
  /// Whether an operand has another sign than in the first lane, compared with the values in its bundle.
  constexpr bool changes_sign(int own, bool minus_own, int other, bool minus_other) const {
    return minus_own != (bundle_[own] != 0 && minus_[other] != 0 ? !minus_other : minus_other);
  }
  constexpr bool has_own_sign(int own, int other) const {
    return own < numbers_ || is_from_outside(own, other);
  }

  /// Puts the operands of a counterpart in order, and finds the sign of its value.
  constexpr void accept(int slot, bool has_two, int other, bool exchanged) {
    if (exchanged) {
      const int left = a_[other];
      a_[other] = b_[other], b_[other] = left;
      const char minus = minus_a_[other];
      minus_a_[other] = minus_b_[other], minus_b_[other] = minus;
    }
    if (!has_two) return;
    const bool a = changes_sign(a_[slot], minus_a_[slot] != 0, a_[other], minus_a_[other] != 0),
               b = changes_sign(b_[slot], minus_b_[slot] != 0, b_[other], minus_b_[other] != 0);
    const operation op = op_[slot - first_];
    const bool is_product = op == operation::multiply || op == operation::divide;
    const bool minus = has_own_sign(a_[slot], a_[other])                  ? b
                       : has_own_sign(b_[slot], b_[other]) || !is_product ? a
                                                                          : a != b;
    if (minus) minus_[other] = 1;
  }

  /// Inputs are bundled where they are first used.
  constexpr void bundle_inputs(int own, const int* steps, const int* operand) {
    if (bundle_[own] != 0 || !is_input(own)) return;
    int all[most_lanes]{};
    for (int k = 0; k < lanes_; ++k) {
      all[k] = operand[steps[k]];
      for (int other = 0; other < k; ++other)
        if (all[other] == all[k]) return;
    }
    add_bundle(all);
  }

  constexpr void add_bundle(const int* members) {
    for (int k = 0; k < lanes_; ++k) {
      found_.members.push(members[k]);
      if (k != 0) lane_[members[k]] = static_cast<char>(k);
    }
    const int bundle = found_.members.size() / lanes_;
    for (int k = 0; k < lanes_; ++k) bundle_[members[k]] = bundle;
  }

  const Tape& tape_;
  int numbers_, first_, end_, lanes_;
  lockstep found_;
  base::zeros<int> first_users_{first_ + end_ + 2}, users_{2 * end_ + 1};
  base::zeros<char> depend_on_branches_{first_ + end_};
  const decltype(Tape::op)& op_{tape_.op};
  base::zeros<int>::array<true>&bundle_{found_.bundles.elements<true>()},
      &root_{found_.root.elements<true>()}, &a_{found_.a.elements<true>()}, &b_{found_.b.elements<true>()},
      &first_user_{first_users_.elements<true>()}, &user_{users_.elements<true>()};
  base::zeros<char>::array<true>&inside_{depend_on_branches_.elements<true>()},
      &lane_{found_.lane.elements<true>()}, &minus_{found_.minus.elements<true>()},
      &minus_a_{found_.minus_a.elements<true>()}, &minus_b_{found_.minus_b.elements<true>()},
      &negated_{found_.negated.elements<true>()};
};

} // namespace detail

} // namespace kanexpr::lower
