#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/base/zeros.hpp>
#include <kanexpr/lower/equal_branches.hpp>
#include <kanexpr/lower/fixed_tape.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

namespace kanexpr::lower {

/// The operands of a step without the changes of sign before it: op(±a, ±b). A difference is a sum.
struct signed_step {
  operation op = operation::constant;
  int a = 0, b = none; ///< slots that no change of sign fills; none if the operation has one operand
  bool minus_a = false, minus_b = false;

  static constexpr int none = -1;
};

/// Bundles of steps of a tape, each of which is the same operation for each of several equal branches. The
/// values of a bundle are the lanes of a vector. They are the values of the steps up to their signs, so that
/// branches that are mirror images of each other run in lockstep too; changes of sign do not round.
struct lockstep {
  static constexpr int none = -1;

  int lanes = 0;
  sequence<int> members{};       ///< slots: for each bundle, one of each lane
  base::zeros<int> bundles{};    ///< of each slot, counted from 1; 0 for none
  base::zeros<char> lane{};      ///< of each slot in a bundle
  base::zeros<char> minus{};     ///< whether the value in the bundle is minus that of the step
  base::zeros<char> exchanged{}; ///< whether the operands of a step are exchanged in the bundle
  base::zeros<int> root{};       ///< of each slot, the slot without the changes of sign before it
  base::zeros<char> negated{};   ///< whether a slot is minus its root

  constexpr int count() const { return lanes == 0 ? 0 : members.size() / lanes; }

  /// The step that fills a slot, with its operands in the order of its bundle.
  constexpr signed_step step_of(const tape_view& t, int slot) const {
    const int i = slot - t.first_step();
    const operation op = t.steps.op[i];
    const int a = t.steps.a[i], b = t.steps.b[i];
    const bool is_difference = op == operation::subtract;
    signed_step s{is_difference ? operation::add : op, root[a], signed_step::none, negated[a] != 0, false};
    if (!symbolic::is_binary(op)) return s;
    s.b = root[b];
    s.minus_b = (negated[b] != 0) != is_difference;
    if (exchanged[slot] == 0) return s;
    return {s.op, s.b, s.a, s.minus_b, s.minus_a};
  }
};

namespace detail {

/// Finds the steps that have the same operands in each of several equal branches, beginning with their
/// arguments. Operands outside the branches are the same for all lanes; numbers may differ.
///
/// All steps of a bundle have the same depth, so that no bundle depends on itself.
class lockstep_search {
public:
  /// Only the steps before `end` are examined, of which the first `given` are computed for all lanes apart.
  constexpr lockstep_search(const tape_view& t, const equal_branches& branches, int given, int end)
      : tape_(t), numbers_(t.numbers.size()), first_(t.first_step()), given_(given), end_(end),
        lanes_(branches.count), op_(t.steps.op), a_(t.steps.a), b_(t.steps.b) {
    const int slots = first_ + end;
    found_.lanes = lanes_;
    found_.bundles.grow(slots), found_.lane.grow(slots), found_.minus.grow(slots);
    found_.exchanged.grow(slots), found_.root.grow(slots), found_.negated.grow(slots), depths_.grow(slots);
    bundle_ = found_.bundles.begin(), root_ = found_.root.begin(), depth_ = depths_.begin();
    negated_ = found_.negated.begin(), minus_ = found_.minus.begin(), lane_ = found_.lane.begin();
    exchanged_ = found_.exchanged.begin();
    for (int first = 0; first < branches.arguments.size(); first += lanes_)
      add_bundle(branches.arguments.begin() + first);
  }
  lockstep_search(const lockstep_search&) = delete;
  lockstep_search& operator=(const lockstep_search&) = delete;

  constexpr lockstep run() {
    find_roots();
    list_users();
    for (int slot = first_; slot < first_ + end_; ++slot)
      if (bundle_[slot] == 0 && op_[slot - first_] != operation::negate) match(slot);
    return static_cast<lockstep&&>(found_);
  }

private:
  static constexpr int none = -1, most_lanes = 4;

  constexpr void find_roots() {
    for (int slot = 0; slot < first_; ++slot) root_[slot] = slot;
    for (int i = 0, slot = first_; i < end_; ++i, ++slot) {
      const int a = a_[i], b = b_[i];
      if (op_[i] == operation::negate) {
        root_[slot] = root_[a];
        negated_[slot] = negated_[a] != 0 ? 0 : 1;
        depth_[slot] = depth_[a];
      } else {
        root_[slot] = slot;
        depth_[slot] = (depth_[a] > depth_[b] ? depth_[a] : depth_[b]) + 1;
      }
    }
  }

  /// Lists the steps that use each slot, up to sign.
  constexpr void list_users() {
    first_user_.grow(first_ + end_ + 2);
    users_.grow(2 * end_);
    int *const first = first_user_.begin() + 1, *const users = users_.begin();
    for (int i = 0; i < end_; ++i) {
      if (op_[i] == operation::negate) continue;
      ++first[root_[a_[i]]];
      if (is_product_or_sum(i)) ++first[root_[b_[i]]];
    }
    int sum = 0;
    for (int slot = 0; slot < first_ + end_; ++slot) {
      const int count = first[slot];
      first[slot] = sum;
      sum += count;
    }
    for (int i = 0; i < end_; ++i) { // afterwards, `first` is behind the users of a slot
      if (op_[i] == operation::negate) continue;
      users[first[root_[a_[i]]]++] = i;
      if (is_product_or_sum(i)) users[first[root_[b_[i]]]++] = i;
    }
  }

  constexpr bool is_product_or_sum(int i) const {
    return op_[i] >= operation::add && op_[i] <= operation::divide;
  }

  constexpr bool can_run(int i) const {
    return is_product_or_sum(i) || (i < given_ && (op_[i] == operation::sin || op_[i] == operation::cos));
  }

  /// The counterpart of a step in another lane.
  struct counterpart {
    int slot = none;
    bool exchanged = false, minus = false;
    int price = 3; ///< 1 if the signs of its terms require a product
  };

  /// Bundles a step with its counterparts in the other lanes, if there is one in each.
  constexpr void match(int slot) {
    if (!can_run(slot - first_)) return;
    const signed_step own = found_.step_of(tape_, slot);
    if (!is_of_first_lane(own.a) || !is_of_first_lane(own.b)) return;
    int anchor = bundle_[own.a] != 0 ? own.a : own.b;
    if (anchor == none || bundle_[anchor] == 0) return;
    if (own.b != none && bundle_[own.a] != 0 && bundle_[own.b] != 0 && uses(own.b) < uses(own.a))
      anchor = own.b;
    int all[most_lanes]{slot};
    counterpart in[most_lanes];
    for (int k = 1; k < lanes_; ++k) {
      in[k] = counterpart_of(slot, own, anchor, k);
      if (in[k].slot == none) return;
      all[k] = in[k].slot;
      for (int other = 0; other < k; ++other)
        if (all[other] == all[k]) return;
    }
    for (int k = 1; k < lanes_; ++k) {
      minus_[all[k]] = in[k].minus ? 1 : 0;
      exchanged_[all[k]] = in[k].exchanged ? 1 : 0;
    }
    bundle_inputs(own.a, all);
    bundle_inputs(own.b, all);
    add_bundle(all);
  }

  constexpr bool is_of_first_lane(int slot) const { return slot == none || lane_[slot] == 0; }
  constexpr int uses(int slot) const { return first_user_[slot + 1] - first_user_[slot]; }

  constexpr counterpart counterpart_of(int slot, const signed_step& own, int anchor, int k) {
    const int i = slot - first_;
    const int same = found_.members[(bundle_[anchor] - 1) * lanes_ + k];
    counterpart best;
    for (int at = first_user_[same], end = first_user_[same + 1]; at < end; ++at) {
      const int j = users_[at], other = first_ + j;
      if (bundle_[other] != 0 || depth_[other] != depth_[slot] || !has_operation(i, j)) continue;
      for (bool exchanged : {false, true}) {
        exchanged_[other] = exchanged ? 1 : 0;
        const counterpart here = compare(own, found_.step_of(tape_, other), other, k);
        if (here.price < best.price) {
          best = here;
          best.exchanged = exchanged;
        }
        if (own.b == none || own.op == operation::divide) break;
      }
      exchanged_[other] = 0;
      if (best.price == 0) break;
    }
    return best;
  }

  constexpr bool has_operation(int i, int j) const {
    const auto is_sum = [](operation op) { return op == operation::add || op == operation::subtract; };
    return op_[i] == op_[j] || (is_sum(op_[i]) && is_sum(op_[j]));
  }

  constexpr counterpart compare(const signed_step& own, const signed_step& other, int slot, int k) const {
    counterpart found;
    if (!is_counterpart(own.a, other.a, k) || (own.b != none && !is_counterpart(own.b, other.b, k)))
      return found;
    const bool a = own.minus_a != is_minus(own.a, other.a, other.minus_a),
               b = own.b != none && own.minus_b != is_minus(own.b, other.b, other.minus_b);
    if (own.b == none) {
      if (a) return found; // functions of negative angles remain outside
      found.minus = false;
    } else if (own.op != operation::add) {
      // the sign of a number belongs to the lane
      found.minus = own.a < numbers_ ? b : own.b < numbers_ ? a : a != b;
    } else {
      found.minus = own.a < numbers_ ? b : a;
    }
    const bool differs = own.op == operation::add && own.a >= numbers_ && own.b >= numbers_ && a != b;
    found.slot = slot;
    found.price = differs ? 1 : 0;
    return found;
  }

  constexpr bool is_counterpart(int own, int other, int k) const {
    if (own < numbers_) return other >= 0 && other < numbers_;
    if (bundle_[own] != 0) return found_.members[(bundle_[own] - 1) * lanes_ + k] == other;
    if (is_input(own) && is_input(other) && bundle_[other] == 0) return true;
    return own == other;
  }
  constexpr bool is_input(int slot) const {
    return slot >= numbers_ && slot < first_ &&
           tape_.loads[slot - numbers_].from == symbolic::symbol_kind::input;
  }
  /// Whether an operand enters with the sign minus, as its bundle has it.
  constexpr bool is_minus(int own, int slot, bool minus) const {
    return bundle_[own] != 0 ? minus != (minus_[slot] != 0) : minus;
  }

  /// Inputs are bundled where they are first used.
  constexpr void bundle_inputs(int own, const int* steps) {
    if (own == none || !is_input(own) || bundle_[own] != 0) return;
    const bool is_first = found_.step_of(tape_, steps[0]).a == own;
    int all[most_lanes]{own};
    for (int k = 1; k < lanes_; ++k) {
      const signed_step s = found_.step_of(tape_, steps[k]);
      all[k] = is_first ? s.a : s.b;
      for (int other = 0; other < k; ++other)
        if (all[other] == all[k]) return;
    }
    add_bundle(all);
  }

  constexpr void add_bundle(const int* slots) {
    for (int k = 0; k < lanes_; ++k) {
      found_.members.push(slots[k]);
      lane_[slots[k]] = static_cast<char>(k);
    }
    for (int k = 0; k < lanes_; ++k) bundle_[slots[k]] = found_.members.size() / lanes_;
  }

  const tape_view& tape_;
  int numbers_, first_, given_, end_, lanes_;
  const operation* op_;
  const int *a_, *b_;
  lockstep found_{};
  base::zeros<int> depths_{}, first_user_{}, users_{}; ///< users are steps
  int *bundle_ = nullptr, *root_ = nullptr, *depth_ = nullptr;
  char *negated_ = nullptr, *minus_ = nullptr, *lane_ = nullptr, *exchanged_ = nullptr;
};

} // namespace detail

} // namespace kanexpr::lower
