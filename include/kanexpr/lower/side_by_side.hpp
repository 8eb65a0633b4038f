#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/lower/tape.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

namespace kanexpr::lower {

namespace detail {

/// Finds steps of several columns of results that may be evaluated as one step on vectors, and makes them
/// contiguous.
///
/// The columns of a solve with many right sides take the same steps, with the same multipliers. Starting at
/// the results, steps of `lanes` columns with similar results are matched, then their operands, as long as
/// the operations are the same and each step serves only its own column; sums and differences count as the
/// same. Where the operands do not match, vectors are gathered from scalars, which pays for at most one of
/// two operands. The operations on each number, and thus its bits, do not change.
class side_by_side {
public:
  constexpr side_by_side(tape&& code, const sequence<int>& columns)
      : code_(static_cast<tape&&>(code)), columns_(columns), first_(code_.first_step()),
        free_(first_ + code_.first_angle + 2 * code_.angle_count), owners_(code_.slot_count(), nobody),
        lane_of_(code_.slot_count(), none), placed_(code_.slot_count(), none), step_(code_.steps.begin()),
        owner_(owners_.begin()), lane_(lane_of_.begin()), place_(placed_.begin()) {}
  side_by_side(const side_by_side&) = delete;
  side_by_side& operator=(const side_by_side&) = delete;

  constexpr tape run() {
    assign_owners();
    list_columns();
    match_columns();
    for (int i = 0; i < packs_.size(); ++i) match_operands(i);
    for (int i = packs_.size() - 1; i >= 0; --i)
      if (!pays(i)) dissolve(i);
    if (kept_ < fewest || !order()) return static_cast<tape&&>(code_);
    return reordered();
  }

private:
  static constexpr int none = -1, nobody = -1, several = -2;
  static constexpr int fewest = 16; ///< fewer vector steps than these are not worth a second form of the code
  enum form : char { other, sum, product, quotient, negative };
  static constexpr int forms = 5;

  struct pack {
    int slot[lanes]{}; ///< none in the first lane after the pack has been dissolved
  };
  struct visit {
    int unit, next;
  };

  /// A step whose value serves a single column belongs to it.
  constexpr void assign_owners() {
    for (int i = 0; i < columns_.size(); ++i)
      if (columns_[i] != none) add_owner(code_.results[i], columns_[i]);
    for (int slot = code_.slot_count() - 1; slot >= free_; --slot) {
      const int who = owner_[slot];
      if (who == nobody) continue;
      const instruction& s = step_[slot - first_];
      add_owner(s.a, who);
      if (symbolic::is_binary(s.op)) add_owner(s.b, who);
    }
  }
  constexpr void add_owner(int slot, int who) {
    if (owner_[slot] != who) owner_[slot] = owner_[slot] == nobody ? who : several;
  }

  constexpr form form_of(int slot) const {
    if (slot < free_ || owner_[slot] < 0) return other;
    const operation op = step_[slot - first_].op;
    if (op == operation::add || op == operation::subtract) return sum;
    if (op == operation::multiply) return product;
    if (op == operation::divide) return quotient;
    return op == operation::negate ? negative : other;
  }

  /// Describes the step of a result and its operands, if it belongs to its column.
  constexpr int shape_of(int slot) const {
    const form own = form_of(slot);
    if (own == other) return 0;
    const instruction& s = step_[slot - first_];
    const int a = form_of(s.a), b = own == negative ? other : form_of(s.b);
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
      entries_[columns_[i]].push(code_.results[i]);
      shapes_[columns_[i]].push(shape_of(code_.results[i]));
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

  constexpr void match_columns() {
    sequence<char> taken(entries_.size(), 0);
    for (int first = 0; first < entries_.size(); ++first) {
      if (taken[first] != 0) continue;
      taken[first] = 1;
      int group[lanes]{};
      for (int& each : group) each = none;
      group[0] = first;
      for (int lane = 1; lane < lanes; ++lane) {
        int best = none, most = 0;
        for (int each = first + 1; each < entries_.size(); ++each) {
          if (taken[each] != 0) continue;
          const int like = likeness(first, each);
          if (like > most) best = each, most = like;
        }
        group[lane] = best;
        if (best == none) break;
        taken[best] = 1;
      }
      if (group[lanes - 1] == none) {
        for (int lane = 1; lane < lanes && group[lane] != none; ++lane) taken[group[lane]] = 0;
        continue;
      }
      int rows = entries_[first].size();
      for (int each : group)
        if (entries_[each].size() < rows) rows = entries_[each].size();
      for (int row = 0; row < rows; ++row) {
        pack results;
        for (int lane = 0; lane < lanes; ++lane) results.slot[lane] = entries_[group[lane]][row];
        match(results);
        for (int each : results.slot) start_.push(each);
      }
    }
  }

  constexpr void match(const pack& p) {
    const form own = form_of(p.slot[0]);
    if (own == other) return;
    for (int i = 0; i < lanes; ++i) {
      if (form_of(p.slot[i]) != own || lane_[p.slot[i]] != none) return;
      for (int j = 0; j < i; ++j)
        if (p.slot[i] == p.slot[j]) return;
    }
    for (int i = 0; i < lanes; ++i) lane_[p.slot[i]] = lanes * packs_.size() + i;
    packs_.push(p);
    ++kept_;
  }

  /// How well two operands fit into one vector.
  constexpr int fit(int one, int two) const {
    if (one == two) return 4;
    const form own = form_of(one);
    if (own == other || own != form_of(two)) return 0;
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
    const bool is_binary = form_of(p.slot[0]) != negative;
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
    int slot[lanes]{};
    bool same = true;
    for (int i = 0; i < lanes; ++i) {
      const instruction& s = step_[p.slot[i] - first_];
      slot[i] = second ? s.b : s.a;
      same = same && slot[i] == slot[0];
    }
    if (same) return false;
    const int first = lane_[slot[0]];
    if (first == none || first % lanes != 0) return true;
    for (int i = 1; i < lanes; ++i)
      if (lane_[slot[i]] != first + i) return true;
    return false;
  }
  constexpr bool pays(int index) const {
    const pack& p = packs_[index];
    return !is_gathered(p, false) || (form_of(p.slot[0]) != negative && !is_gathered(p, true));
  }
  constexpr void dissolve(int index) {
    for (int each : packs_[index].slot) lane_[each] = none;
    packs_[index].slot[0] = none;
    --kept_;
  }

  /// A unit of the order is a pack, a sine with its cosine, or a step; returns its first slot.
  constexpr int unit_of(int slot) const {
    if (lane_[slot] != none) return packs_[lane_[slot] / lanes].slot[0];
    const instruction& s = step_[slot - first_];
    return s.paired && s.op == operation::cos ? slot - 1 : slot;
  }
  /// Returns operand number `which` of a unit, or none after the last.
  constexpr int operand_of(int unit, int which) const {
    const bool is_pack = lane_[unit] != none;
    if (which >= (is_pack ? 2 * lanes : 2)) return none;
    const int slot = is_pack ? packs_[lane_[unit] / lanes].slot[which / 2] : unit;
    const instruction& s = step_[slot - first_];
    return which % 2 == 0 || !symbolic::is_binary(s.op) ? s.a : s.b;
  }

  /// Orders the units so that operands precede; returns false if packs depend on each other.
  constexpr bool order() {
    for (int slot = 0; slot < free_; ++slot) place_[slot] = slot;
    next_ = free_;
    for (int each : start_)
      if (!put_with_operands(each)) return false;
    for (int each : code_.results)
      if (!put_with_operands(each)) return false;
    return next_ == code_.slot_count();
  }
  constexpr bool put_with_operands(int result) {
    constexpr int begun = -2;
    if (place_[result] >= 0) return true;
    sequence<visit> path;
    path.push({unit_of(result), 0});
    place_[path[0].unit] = begun;
    while (path.size() > 0) {
      visit& now = path[path.size() - 1];
      const int operand = operand_of(now.unit, now.next++);
      if (operand == none) {
        put(now.unit);
        path.pop();
      } else if (place_[operand] == none || place_[operand] == begun) {
        const int unit = unit_of(operand);
        if (place_[unit] == begun) return false;
        place_[unit] = begun;
        path.push({unit, 0});
      }
    }
    return true;
  }
  constexpr void put(int unit) {
    if (lane_[unit] != none) {
      vector_steps_.push(next_ - first_);
      for (int each : packs_[lane_[unit] / lanes].slot) place_[each] = next_++;
    } else {
      place_[unit] = next_++;
      if (step_[unit - first_].paired) place_[unit + 1] = next_++;
    }
  }

  constexpr tape reordered() {
    sequence<instruction> steps(code_.steps.size());
    for (int slot = first_; slot < code_.slot_count(); ++slot) {
      instruction s = step_[slot - first_];
      s.a = place_[s.a];
      if (symbolic::is_binary(s.op)) s.b = place_[s.b];
      steps[place_[slot] - first_] = s;
    }
    code_.steps = static_cast<sequence<instruction>&&>(steps);
    for (int& each : code_.results) each = place_[each];
    code_.vector_steps = static_cast<sequence<int>&&>(vector_steps_);
    return static_cast<tape&&>(code_);
  }

  tape code_;
  const sequence<int>& columns_;
  int first_, free_; ///< the first slot that a step fills, and the first one that may move
  sequence<int> owners_, lane_of_, placed_;
  instruction* step_;
  int* owner_;                                   ///< the column to which each slot belongs
  int* lane_;                                    ///< the lane of each slot, counted over all packs
  int* place_;                                   ///< the new slot of each slot
  sequence<sequence<int>> entries_{}, shapes_{}; ///< of the results, by column
  sequence<pack> packs_{};
  sequence<int> start_{}, vector_steps_{};
  int kept_ = 0, next_ = 0;
};

} // namespace detail

/// Moves steps of a tape that may be evaluated as one step on vectors next to each other. `columns` contains
/// the column of each result, or -1.
constexpr tape with_vector_steps(tape&& code, const sequence<int>& columns) {
  if (code.linear_steps.size() > 0 || columns.size() < 8 * lanes) return static_cast<tape&&>(code);
  return detail::side_by_side(static_cast<tape&&>(code), columns).run();
}

} // namespace kanexpr::lower
