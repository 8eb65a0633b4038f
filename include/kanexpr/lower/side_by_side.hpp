#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/lower/fixed_tape.hpp>
#include <kanexpr/lower/tape.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

namespace kanexpr::lower {

/// The number of steps that form one step on vectors.
inline constexpr int lanes = 4;

/// Steps that may be evaluated as one step on vectors. Sums and differences count as one operation.
struct pack {
  int slot[lanes]{};
  int signs = 0; ///< one bit per lane: whether the second operand of a sum or the first one of a product
                 ///< changes its sign
};

/// Finds steps of several columns of results that may be evaluated as one step on vectors.
///
/// The columns of a solve with many right sides take the same steps, with the same multipliers. Starting at
/// the results, steps of `lanes` columns with similar results are matched, then their operands, as long as
/// the operations are the same and each step serves only its own column. Where the operands do not match,
/// vectors are gathered from scalars, which pays for at most one of two operands. The operations on each
/// number, and thus its bits, do not change.
class side_by_side {
  static constexpr int none = -1;

public:
  /// `columns` contains the column of each result, or -1.
  constexpr side_by_side(const tape_view& code, const view<int>& columns, int first_free)
      : results_(code.results), columns_(columns), first_(code.first_step()), count_(code.slot_count()),
        free_(first_free), steps_(code.steps.size()), forms_(count_, other), lane_of_(count_, none),
        done_(count_, waiting), step_(steps_.begin()), form_(forms_.begin()), lane_(lane_of_.begin()),
        is_done_(done_.begin()) {
    for (int i = 0, end = code.steps.size(); i < end; ++i) step_[i] = code.steps[i];
    assign_owners();
    list_columns();
    match_columns();
    for (int i = 0; i < packs_.size(); ++i) match_operands(i);
    for (int i = packs_.size() - 1; i >= 0; --i)
      if (!pays(i)) dissolve(i);
    while (!order()) {
    }
    place_signs();
  }
  side_by_side(const side_by_side&) = delete;
  side_by_side& operator=(const side_by_side&) = delete;

  constexpr const sequence<pack>& packs() const { return packs_; }
  /// The steps in an order in which operands precede. Of a pack, only the first lane is listed; a sine is
  /// followed by its cosine.
  constexpr const sequence<int>& order_of_slots() const { return units_; }
  /// Returns the step of a slot. The operands of sums and products may be exchanged, so that those of all
  /// lanes match.
  constexpr const instruction& step_of(int slot) const { return step_[slot - first_]; }
  /// Returns `lanes` times the index of the pack plus the lane of a slot, or -1.
  constexpr int lane_of(int slot) const { return lane_[slot]; }

  /// The slots of the first or the second operand of each lane.
  constexpr pack operands_of(const pack& p, bool second) const {
    pack found;
    for (int i = 0; i < lanes; ++i) {
      const instruction& s = step_[p.slot[i] - first_];
      found.slot[i] = second ? s.b : s.a;
    }
    return found;
  }
  /// Returns the index of the pack that consists of these slots, or -1.
  constexpr int pack_of(const pack& p) const {
    const int first = lane_[p.slot[0]];
    if (first % lanes != 0) return none; // also if it is none
    for (int i = 1; i < lanes; ++i)
      if (lane_[p.slot[i]] != first + i) return none;
    return first / lanes;
  }

private:
  static constexpr int nobody = -1, several = -2;
  enum progress : char { waiting, begun, finished };
  enum form : char { other, sum, product, quotient, negative };
  static constexpr int forms = 5;

  struct visit {
    int unit, next;
  };

  /// A step whose value serves a single column belongs to it. Only such steps have a form.
  constexpr void assign_owners() {
    sequence<int> owners(count_, nobody);
    int* const owner = owners.begin();
    for (int i = 0; i < results_.size(); ++i)
      if (int& it = owner[results_[i]]; it != columns_[i] || it == none)
        it = it == nobody && columns_[i] != none ? columns_[i] : several;
    for (int slot = count_ - 1; slot >= free_; --slot) {
      const int who = owner[slot];
      if (who == nobody) continue;
      const instruction& s = step_[slot - first_];
      if (owner[s.a] != who) owner[s.a] = owner[s.a] == nobody ? who : several;
      if (symbolic::is_binary(s.op) && owner[s.b] != who) owner[s.b] = owner[s.b] == nobody ? who : several;
      if (who >= 0) form_[slot] = form_of_operation(s.op);
    }
  }
  static constexpr form form_of_operation(operation op) {
    if (op == operation::add || op == operation::subtract) return sum;
    if (op == operation::multiply) return product;
    if (op == operation::divide) return quotient;
    return op == operation::negate ? negative : other;
  }

  /// Describes the step of a result and its operands, if it belongs to its column.
  constexpr int shape_of(int slot) const {
    const form own = form_[slot];
    if (own == other) return 0;
    const instruction& s = step_[slot - first_];
    const int a = form_[s.a], b = own == negative ? other : form_[s.b];
    return (own * forms + (a < b ? a : b)) * forms + (a < b ? b : a);
  }

  constexpr void list_columns() {
    int count = 0;
    for (int each : columns_)
      if (each >= count) count = each + 1;
    entries_.resize(count);
    shapes_.resize(count);
    for (int i = 0; i < columns_.size(); ++i) {
      if (columns_[i] == none) continue;
      entries_[columns_[i]].push(results_[i]);
      shapes_[columns_[i]].push(shape_of(results_[i]));
    }
  }

  /// The number of rows in which two columns have results of the same shape.
  constexpr int likeness(int one, int two) const {
    int count = 0;
    const sequence<int>&a = shapes_[one], &b = shapes_[two];
    const int* const p = a.begin();
    const int* const q = b.begin();
    for (int i = 0, end = a.size() < b.size() ? a.size() : b.size(); i < end; ++i)
      if (p[i] != 0 && p[i] == q[i]) ++count;
    return count;
  }

  /// Joins each column with those that are the most similar among the remaining ones.
  constexpr void match_columns() {
    const int count = entries_.size();
    sequence<char> taken(count, 0);
    sequence<int> like(count, 0);
    for (int first = 0; first < count; ++first) {
      if (taken[first] != 0) continue;
      for (int each = first + 1; each < count; ++each)
        like[each] = taken[each] != 0 ? 0 : likeness(first, each);
      int group[lanes]{};
      group[0] = first;
      int found = 1;
      for (; found < lanes; ++found) {
        int best = none, most = 0;
        for (int each = first + 1; each < count; ++each)
          if (like[each] > most) best = each, most = like[each];
        if (best == none) break;
        group[found] = best;
        like[best] = 0;
      }
      if (found < lanes) continue;
      for (int each : group) taken[each] = 1;
      match_rows(group);
    }
  }
  constexpr void match_rows(const int (&group)[lanes]) {
    int rows = entries_[group[0]].size();
    for (int each : group)
      if (entries_[each].size() < rows) rows = entries_[each].size();
    for (int row = 0; row < rows; ++row) {
      pack results;
      for (int lane = 0; lane < lanes; ++lane) results.slot[lane] = entries_[group[lane]][row];
      match(results);
      for (int each : results.slot) start_.push(each);
    }
  }

  constexpr void match(const pack& p) {
    const form own = form_[p.slot[0]];
    if (own == other) return;
    for (int i = 0; i < lanes; ++i) {
      if (form_[p.slot[i]] != own || lane_[p.slot[i]] != none) return;
      for (int j = 0; j < i; ++j)
        if (p.slot[i] == p.slot[j]) return;
    }
    for (int i = 0; i < lanes; ++i) lane_[p.slot[i]] = lanes * packs_.size() + i;
    packs_.push(p);
  }

  /// How well two operands fit into one vector.
  constexpr int fit(int one, int two) const {
    if (one == two) return 4;
    const form own = form_[one];
    if (own == other || own != form_[two]) return 0;
    const instruction &a = step_[one - first_], &b = step_[two - first_];
    return a.a == b.a || a.b == b.b || a.a == b.b || a.b == b.a ? 3 : 1;
  }

  constexpr bool commutes(int slot) const {
    const operation op = step_[slot - first_].op;
    return op == operation::add || op == operation::multiply;
  }

  /// Exchanges operands of sums and products so that those of all lanes fit, and matches them.
  constexpr void match_operands(int index) {
    const pack p = packs_[index];
    int model = 0;
    for (int i = lanes - 1; i >= 0; --i)
      if (!commutes(p.slot[i])) model = i;
    const bool is_binary = form_[p.slot[0]] != negative;
    const instruction& like = step_[p.slot[model] - first_];
    pack a, b;
    for (int i = 0; i < lanes; ++i) {
      instruction& s = step_[p.slot[i] - first_];
      if (is_binary && i != model && commutes(p.slot[i]) &&
          fit(like.a, s.b) + fit(like.b, s.a) > fit(like.a, s.a) + fit(like.b, s.b)) {
        const int first = s.a;
        s.a = s.b;
        s.b = first;
      }
      a.slot[i] = s.a;
      b.slot[i] = s.b;
    }
    match(a);
    if (is_binary) match(b);
  }

  /// Whether an operand of a pack must be gathered from scalars.
  constexpr bool is_gathered(const pack& p, bool second) const {
    const pack operands = operands_of(p, second);
    for (int each : operands.slot)
      if (each != operands.slot[0]) return pack_of(operands) == none;
    return false;
  }
  constexpr bool pays(int index) const {
    const pack& p = packs_[index];
    return !is_gathered(p, false) || (form_[p.slot[0]] != negative && !is_gathered(p, true));
  }
  constexpr void dissolve(int index) {
    for (int each : packs_[index].slot) lane_[each] = none;
    packs_[index].slot[0] = none;
  }

  /// In sums with different signs, changes the sign of one factor rather than that of the product, which
  /// would have to be rounded before its sign changes.
  constexpr void place_signs() {
    sequence<int> uses(count_, 0);
    for (int each : results_) ++uses[each];
    for (const instruction& s : steps_) {
      ++uses[s.a];
      if (symbolic::is_binary(s.op)) ++uses[s.b];
    }
    for (pack& p : packs_) {
      if (p.slot[0] == none || form_[p.slot[0]] != sum) continue;
      for (int i = 0; i < lanes; ++i)
        if (step_[p.slot[i] - first_].op == operation::subtract) p.signs |= 1 << i;
      if (p.signs == 0 || p.signs == (1 << lanes) - 1) continue;
      const int operand = pack_of(operands_of(p, true));
      if (operand == none || form_[packs_[operand].slot[0]] != product) continue;
      bool is_only_use = true;
      for (int each : packs_[operand].slot) is_only_use = is_only_use && uses[each] == 1;
      if (!is_only_use) continue;
      packs_[operand].signs = p.signs;
      p.signs = 0;
    }
  }

  /// A unit of the order is a pack, a sine with its cosine, or a step; returns its first slot.
  constexpr int unit_of(int slot) const {
    return lane_[slot] == none ? slot : packs_[lane_[slot] / lanes].slot[0];
  }
  /// Returns operand number `which` of a unit, or none after the last.
  constexpr int operand_of(int unit, int which) const {
    const bool is_pack = lane_[unit] != none;
    if (which >= (is_pack ? 2 * lanes : 2)) return none;
    const int slot = is_pack ? packs_[lane_[unit] / lanes].slot[which / 2] : unit;
    const instruction& s = step_[slot - first_];
    return which % 2 == 0 || !symbolic::is_binary(s.op) ? s.a : s.b;
  }

  /// Orders the units: first the steps that serve several columns, in the order of the tape, then the others
  /// by the results that need them. If two packs depend on each other, one of them is dissolved and the order
  /// is not complete.
  constexpr bool order() {
    for (char& each : done_) each = waiting;
    units_.clear();
    units_.reserve(count_ - free_);
    for (int slot = 0; slot < count_; ++slot)
      if (slot < free_ || form_[slot] == other) {
        is_done_[slot] = finished;
        if (slot >= free_ && !is_cosine(slot)) units_.push(slot);
      }
    for (int each : start_)
      if (!put_with_operands(each)) return false;
    for (int each : results_)
      if (!put_with_operands(each)) return false;
    return true;
  }
  /// Whether a step is computed with the one before.
  constexpr bool is_cosine(int slot) const {
    const instruction& s = step_[slot - first_];
    return s.paired && s.op == operation::cos;
  }
  constexpr bool put_with_operands(int result) {
    const int begin = unit_of(result);
    if (is_done_[begin] != waiting) return true;
    path_.clear();
    path_.push({begin, 0});
    is_done_[begin] = begun;
    while (path_.size() > 0) {
      visit& now = path_.back();
      const int operand = operand_of(now.unit, now.next++);
      if (operand == none) {
        is_done_[now.unit] = finished;
        units_.push(now.unit);
        path_.pop();
      } else if (is_done_[operand] != finished) {
        const int unit = unit_of(operand);
        if (is_done_[unit] == begun) return dissolve_one_behind(unit);
        if (is_done_[unit] == finished) continue;
        is_done_[unit] = begun;
        path_.push({unit, 0});
      }
    }
    return true;
  }
  constexpr bool dissolve_one_behind(int unit) {
    int i = path_.size() - 1;
    while (path_[i].unit != unit && lane_[path_[i].unit] == none) --i;
    dissolve(lane_[path_[i].unit] / lanes);
    return false;
  }

  const view<int> results_, columns_;
  int first_, count_,
      free_; ///< the first slot that a step fills, their number, and the first one that may move
  sequence<instruction> steps_;
  sequence<form> forms_;
  sequence<int> lane_of_;
  sequence<char> done_;
  instruction* step_;
  form* form_;                                   ///< the form of each step that serves a single column
  int* lane_;                                    ///< the lane of each slot, counted over all packs
  char* is_done_;                                ///< the progress of each unit
  sequence<sequence<int>> entries_{}, shapes_{}; ///< of the results, by column
  sequence<pack> packs_{};
  sequence<int> start_{}, units_{};
  sequence<visit> path_{};
};

} // namespace kanexpr::lower
