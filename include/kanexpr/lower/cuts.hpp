#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/lower/fixed_tape.hpp>
#include <kanexpr/lower/tape.hpp>
#include <kanexpr/numeric/elimination.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

#include <cstdint>

namespace kanexpr::lower {

/// The positions at which a long tape is cut into pieces, and the places in memory of the values that several
/// pieces use.
struct cuts {
  sequence<int> first{}; ///< the first step of each piece, followed by the number of steps
  sequence<int> place{}; ///< of each slot; none if only the piece that computes its value uses it
  int places = 0;

  static constexpr int none = -1;
};

namespace detail {

/// Visits the slots that a step of a tape reads. `next` is the number of the linear steps before it.
template <class Visit>
constexpr void visit_operands(const tape_view& t, int step, int next, const Visit& visit) {
  if (next < t.linear_steps.size() && t.linear_steps[next].step == step) {
    const linear_step& e = t.linear_steps[next];
    for (int i = 0; i < e.inputs(); ++i) visit(t.operands[e.operands + i]);
    if (e.op == operation::factorization || e.op == operation::call) return;
    for (int i = 0, end = numeric::factors{e.order}.size(); i < end; ++i) visit(e.factors + i);
  } else if (t.steps.op[step] < operation::pair) {
    visit(t.steps.a[step]);
    if (symbolic::is_binary(t.steps.op[step])) visit(t.steps.b[step]);
  }
}

/// Cuts a tape where few values are live, into pieces of about the same length.
///
/// A value that later pieces read, an argument or a result has a place in memory. A place is used again only
/// by pieces that follow the last one that reads it, so that within a piece all places are distinct.
class cutting {
public:
  /// Steps before `uncut` remain in the first piece.
  constexpr cutting(const tape_view& t, int uncut, int length)
      : tape_(t), uncut_(uncut), length_(length), last_use_(t.slot_count(), cuts::none),
        is_joined_(t.steps.size() + 1, 0) {}

  constexpr cuts run() {
    find_last_uses();
    join_steps();
    choose_cuts();
    found_.place.resize(tape_.slot_count(), cuts::none);
    for (int i = 0; i < tape_.loads.size(); ++i) found_.place[tape_.numbers.size() + i] = found_.places++;
    for (int slot : tape_.results)
      if (found_.place[slot] == cuts::none) found_.place[slot] = found_.places++;
    assign_places();
    return static_cast<cuts&&>(found_);
  }

private:
  constexpr void find_last_uses() {
    int* const last_use = last_use_.begin();
    for (int step = 0, next = 0; step < tape_.steps.size(); ++step) {
      visit_operands(tape_, step, next, [&](int slot) { last_use[slot] = step; });
      if (next < tape_.linear_steps.size() && tape_.linear_steps[next].step == step) ++next;
    }
  }

  /// Marks the steps that must not begin a piece: all but the first of a step that fills several slots, and a
  /// sum that follows its products, because processors can contract both into one operation.
  constexpr void join_steps() {
    const int count = tape_.steps.size();
    for (int i = 0; i < tape_.linear_steps.size(); ++i) {
      const linear_step& e = tape_.linear_steps[i];
      for (int k = 1; k < e.outputs(); ++k) is_joined_[e.step + k] = 1;
    }
    for (int step = 0; step < count; ++step) {
      if (tape_.steps.paired[step] && tape_.steps.op[step] == operation::cos) is_joined_[step] = 1;
      if (tape_.steps.op[step] != operation::multiply) continue;
      for (int k = step + 1; k <= step + 2 && k < count; ++k)
        if (last_use_[tape_.first_step() + step] == k)
          for (int j = step + 1; j <= k; ++j) is_joined_[j] = 1;
    }
  }

  constexpr void choose_cuts() {
    const int count = tape_.steps.size(), first_step = tape_.first_step();
    sequence<int> change(count + 1, 0); // of the number of live values, by step
    for (int step = 0; step < count; ++step) {
      const int last = last_use_[first_step + step];
      if (last <= step) continue;
      ++change[step + 1];
      if (last < count) --change[last + 1];
    }
    int live = 0;
    for (int step = 0; step <= count; ++step) change[step] = live += change[step];
    int begin = 0;
    found_.first.push(begin);
    while (count - begin > length_ + length_ / 4) {
      int best = cuts::none;
      for (int step = begin + length_ - length_ / 4; step < count; ++step) {
        if (best != cuts::none && step > begin + length_ + length_ / 4) break;
        if (step > uncut_ && is_joined_[step] == 0 && (best == cuts::none || change[step] < change[best]))
          best = step;
      }
      if (best == cuts::none) break;
      found_.first.push(begin = best);
    }
    found_.first.push(count);
  }

  constexpr void assign_places() {
    const int pieces = found_.first.size() - 1, first_step = tape_.first_step();
    sequence<int> piece_of(tape_.steps.size());
    for (int piece = 0; piece < pieces; ++piece)
      for (int step = found_.first[piece]; step < found_.first[piece + 1]; ++step) piece_of[step] = piece;
    sequence<int> released(pieces, cuts::none); // a list of the places that each piece is the last to read
    sequence<int> following, free;              // by place
    for (int piece = 0; piece < pieces; ++piece) {
      for (int step = found_.first[piece]; step < found_.first[piece + 1]; ++step) {
        int& place = found_.place[first_step + step];
        const int last = last_use_[first_step + step];
        if (place != cuts::none || last < found_.first[piece + 1]) continue;
        if (free.empty()) {
          place = found_.places++;
        } else {
          place = free.back();
          free.pop();
        }
        following.resize(found_.places, cuts::none);
        following[place] = released[piece_of[last]];
        released[piece_of[last]] = place;
      }
      for (int place = released[piece]; place != cuts::none; place = following[place]) free.push(place);
    }
  }

  const tape_view& tape_;
  int uncut_, length_;
  sequence<int> last_use_; ///< the last step that reads each slot
  sequence<char> is_joined_;
  cuts found_{};
};

} // namespace detail

/// The steps of a tape from `begin` to `end` as a tape whose numbers and loads are the numbers and the values
/// in memory that they read.
constexpr tape piece_of(const tape_view& whole, const int* place, int begin, int end) {
  tape piece;
  const int first_step = whole.first_step(), own = first_step + begin;
  int linear = 0;
  while (linear < whole.linear_steps.size() && whole.linear_steps[linear].step < begin) ++linear;

  // one bit for each slot that is read, in the order of the slots, so that factors remain contiguous
  constexpr int bits = 64;
  sequence<std::uint64_t> read(own / bits + 1, 0);
  for (int step = begin, next = linear; step < end; ++step) {
    detail::visit_operands(whole, step, next, [&](int slot) {
      if (slot < own) read[slot / bits] |= std::uint64_t{1} << (slot % bits);
    });
    if (next < whole.linear_steps.size() && whole.linear_steps[next].step == step) ++next;
  }
  sequence<int> before(read.size(), 0); // how many preceding slots are read, by word
  int inputs = 0;
  for (int word = 0; word < read.size(); ++word) {
    before[word] = inputs;
    for (std::uint64_t rest = read[word]; rest != 0; rest &= rest - 1, ++inputs) {
      const int slot = bits * word + __builtin_ctzll(rest);
      if (slot < whole.numbers.size())
        piece.numbers.push(whole.numbers[slot]);
      else
        piece.loads.push({symbolic::symbol_kind{}, place[slot]});
    }
  }
  const auto slot_in_piece = [&](int slot) {
    if (slot >= own) return inputs + slot - own;
    const std::uint64_t lower = (std::uint64_t{1} << (slot % bits)) - 1;
    return before[slot / bits] + __builtin_popcountll(read[slot / bits] & lower);
  };

  piece.steps.reserve(end - begin);
  for (int step = begin; step < end; ++step) {
    instruction s = whole.steps[step];
    s.a = s.op < operation::pair ? slot_in_piece(s.a) : 0;
    s.b = s.op < operation::pair && symbolic::is_binary(s.op) ? slot_in_piece(s.b) : 0;
    piece.steps.push(s);
  }
  for (; linear < whole.linear_steps.size() && whole.linear_steps[linear].step < end; ++linear) {
    linear_step e = whole.linear_steps[linear];
    const int operands = e.operands;
    e.step -= begin;
    e.operands = piece.operands.size();
    for (int i = 0; i < e.inputs(); ++i) piece.operands.push(slot_in_piece(whole.operands[operands + i]));
    if (e.op == operation::call) {
      const symbolic::external_function* const f = whole.externals[e.factors];
      e.factors = piece.externals.find(f);
      if (e.factors < 0) e.factors = piece.externals.push(f);
    } else if (e.op != operation::factorization) {
      e.factors = slot_in_piece(e.factors);
    }
    piece.linear_steps.push(e);
  }
  return piece;
}

} // namespace kanexpr::lower
