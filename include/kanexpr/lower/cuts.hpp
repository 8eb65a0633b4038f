#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/base/zeros.hpp>
#include <kanexpr/lower/choose_cuts.hpp>
#include <kanexpr/lower/fixed_tape.hpp>
#include <kanexpr/lower/tape.hpp>
#include <kanexpr/lower/vector_columns.hpp>
#include <kanexpr/numeric/elimination.hpp>
#include <kanexpr/numeric/symmetric_columns.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

#include <cstdint>

namespace kanexpr::lower {

/// The positions at which a long tape is cut into pieces, and the places in memory of the values that several
/// pieces use.
struct cuts {
  static constexpr int none = -1;

  sequence<int> first{};         ///< the first step of each piece, followed by the number of steps
  sequence<int> first_input{};   ///< of each piece, followed by the number of inputs of all pieces
  sequence<int> first_operand{}; ///< of the linear steps of each piece, followed by the number of operands
  sequence<int> first_linear{};  ///< the first linear step of each piece, followed by their number
  sequence<int> numbers{};       ///< how many inputs of each piece are numbers; they precede the others
  base::zeros<int> inputs;       ///< slots that a piece reads but does not fill, in their order
  int input_count = 0;           ///< of all pieces
  base::zeros<int> a, b;         ///< of each step, as slots of its piece, which follow the inputs
  sequence<int> operands{};      ///< of the linear steps, as slots of their pieces
  sequence<int> factors{};       ///< of the linear steps, as slots of their pieces
  base::zeros<int> place;        ///< of each slot; none if only the piece that fills it reads it
  sequence<int> solves{};        ///< for each piece, the symmetric system that it is; none for other steps
  sequence<int> columns{};       ///< the place of the columns of each linear step that is such a system
  int places = 0;

  template <class Tape>
  constexpr explicit cuts(const Tape& t)
      : inputs(2 * t.sizes.steps + t.sizes.operands), a(t.sizes.steps), b(t.sizes.steps),
        place(t.slot_count()) {}
};

namespace detail {

/// Cuts a tape where few values are live, into pieces of about the same length.
///
/// A value that later pieces read, an argument or a result has a place in memory. A place is used again only
/// by pieces that follow the last one that reads it, so that within a piece all places are distinct. The code
/// runs only in constant evaluation, and accesses arrays directly because compilers interpret every call.
template <class Tape>
class cutting {
public:
  /// Steps before `uncut` remain in the first piece.
  constexpr cutting(const Tape& t, int uncut, int length)
      : tape_(t), count_(t.sizes.steps), slots_(t.slot_count()), first_step_(t.first_step()), uncut_(uncut),
        length_(length), last_uses_(slots_), changes_(count_ + 2), found_(t) {}
  cutting(const cutting&) = delete;
  cutting& operator=(const cutting&) = delete;

  constexpr cuts run() {
    find_last_uses();
    count_live_values();
    join_steps();
    cut_between_systems();
    assign_places();
    number_slots_of_pieces();
    return static_cast<cuts&&>(found_);
  }

private:
  static constexpr int factors_of(const linear_step& e) {
    const bool none =
        e.op == operation::factorization || e.op == operation::call || e.op == operation::symmetric_solve;
    return none ? 0 : numeric::factors{e.order}.size();
  }

  constexpr void find_last_uses() {
    const auto& ops = tape_.op;
    const auto &a = tape_.a, &b = tape_.b;
    auto& last_use = last_use_;
    for (int slot = 0; slot < slots_; ++slot) last_use[slot] = cuts::none;
    for (int step = 0; step < count_; ++step) {
      const operation op = ops[step];
      if (op >= operation::pair) continue;
      last_use[a[step]] = step;
      if (op <= operation::divide ? op != operation::negate : symbolic::is_binary(op))
        last_use[b[step]] = step;
    }
    const auto use = [&](int slot, int step) {
      if (last_use_[slot] < step) last_use_[slot] = step;
    };
    for (int index = 0; index < tape_.sizes.linear_steps; ++index) {
      const linear_step& e = tape_.linear_steps[index];
      for (int i = 0; i < e.inputs(); ++i) use(tape_.operands[e.operands + i], e.step);
      for (int i = 0; i < factors_of(e); ++i) use(e.factors + i, e.step);
    }
  }

  /// Counts the values that steps before each step compute and later ones read.
  constexpr void count_live_values() {
    const auto& last_use = last_use_;
    auto& change = change_;
    for (int step = 0; step <= count_ + 1; ++step) change[step] = 0;
    for (int step = 0; step < count_; ++step) {
      const int last = last_use[first_step_ + step];
      if (last <= step) continue;
      ++change[step + 1];
      --change[last + 1];
    }
    int live = 0;
    for (int step = 0; step <= count_; ++step) change[step] = live += change[step];
  }

  /// Excludes steps that must not begin a piece: all but the first of a step that fills several slots, and a
  /// sum that follows its products, because processors can contract both into one operation.
  constexpr void join_steps() {
    const auto& op = tape_.op;
    const auto& last_use = last_use_;
    auto& change = change_;
    for (int step = 0; step < count_; ++step) {
      if (op[step] == operation::multiply) {
        const int last = last_use[first_step_ + step];
        if (last == step + 1 || last == step + 2) change[step + 1] = change[last] = uncuttable;
      } else if (op[step] == operation::cos && tape_.paired[step]) {
        change[step] = uncuttable;
      }
    }
    for (int i = 0; i < tape_.sizes.linear_steps; ++i) {
      const linear_step& e = tape_.linear_steps[i];
      for (int k = 1; k < e.outputs(); ++k) change[e.step + k] = uncuttable;
    }
    for (int step = 0; step <= uncut_ && step < count_; ++step) change[step] = uncuttable;
  }

  constexpr void cut_between_systems() {
    int begin = 0;
    for (int i = 0; i < tape_.sizes.linear_steps; ++i) {
      const linear_step& e = tape_.linear_steps[i];
      if (e.op != operation::symmetric_solve) continue;
      cut(begin, e.step);
      found_.first.push(e.step);
      found_.solves.push(i);
      begin = e.step + e.outputs();
    }
    cut(begin, count_);
    found_.first.push(count_);
  }

  constexpr void cut(int begin, int end) {
    if (begin == end) return;
    const auto add = [&](int first) {
      found_.first.push(first);
      found_.solves.push(cuts::none);
    };
    add(begin);
    choose_cuts(change_, begin, end, length_, add);
  }

  constexpr void assign_places() {
    auto& place = place_;
    for (int slot = 0; slot < slots_; ++slot) place[slot] = cuts::none;
    for (int i = 0; i < tape_.sizes.loads; ++i) place[tape_.sizes.numbers + i] = found_.places++;
    assign_columns();
    for (int i = 0; i < tape_.sizes.results; ++i)
      if (const int slot = tape_.results[i]; slot >= tape_.sizes.numbers && place[slot] == cuts::none)
        place[slot] = found_.places++;
    const int pieces = found_.first.size() - 1;
    sequence<int> released(pieces, cuts::none); // a list of the places that each piece is the last to read
    base::zeros<int> following_places(found_.places + count_), free_places(found_.places + count_);
    auto &following = following_places.elements<true>(), &free = free_places.elements<true>();
    int free_count = 0;
    const auto& last_use = last_use_;
    for (int piece = 0; piece < pieces; ++piece) {
      const int end = found_.first[piece + 1];
      for (int step = found_.first[piece]; step < end; ++step) {
        const int last = last_use[first_step_ + step];
        if (last < end || place[first_step_ + step] != cuts::none) continue;
        int reader = piece + 1;
        while (found_.first[reader + 1] <= last) ++reader;
        const int own = free_count == 0 ? found_.places++ : free[--free_count];
        place[first_step_ + step] = own;
        following[own] = released[reader];
        released[reader] = own;
      }
      for (int each = released[piece]; each != cuts::none; each = following[each]) free[free_count++] = each;
    }
  }

  /// Gives places to the columns of symmetric systems. Entries of right-hand sides are computed in place
  /// unless something else needs them while, or after, the system is solved.
  constexpr void assign_columns() {
    auto& place = place_;
    found_.columns.resize(tape_.sizes.linear_steps, cuts::none);
    for (int i = 0; i < tape_.sizes.linear_steps; ++i) {
      const linear_step& e = tape_.linear_steps[i];
      if (e.op != operation::symmetric_solve) continue;
      const int first = found_.columns[i] = found_.places, stride = stride_for(e.factors);
      found_.places += e.order * stride;
      for (int k = 0; k < e.outputs(); ++k)
        place[first_step_ + e.step + k] = first + k / e.factors * stride + k % e.factors;
    }
    for (int i = 0; i < tape_.sizes.results; ++i) last_use_[tape_.results[i]] = count_;
    for (int index = 0; index < tape_.sizes.linear_steps; ++index) {
      const linear_step& e = tape_.linear_steps[index];
      if (e.op != operation::symmetric_solve) continue;
      const int right = e.operands + numeric::symmetric_factors{e.order}.size();
      for (int i = e.operands; i < right; ++i)
        last_use_[tape_.operands[i]] += 1; // a factor is read for each column
      for (int k = 0; k < e.outputs(); ++k) {
        const int slot = tape_.operands[right + k];
        if (slot >= first_step_ && place[slot] == cuts::none && last_use_[slot] == e.step)
          place[slot] = place[first_step_ + e.step + k];
      }
      for (int i = e.operands; i < right; ++i) last_use_[tape_.operands[i]] -= 1;
    }
  }

  /// Numbers the slots of each piece: its numbers, its other inputs and its steps. The inputs are in the
  /// order of the tape, so that factors remain contiguous.
  constexpr void number_slots_of_pieces() {
    const auto& ops = tape_.op;
    const auto &first_operand = tape_.a, &second_operand = tape_.b;
    auto &a = a_, &b = b_, &number = number_;
    for (int slot = 0; slot < slots_; ++slot) number[slot] = 0;
    int linear = 0;
    for (int piece = 0; piece + 1 < found_.first.size(); ++piece) {
      const int begin = found_.first[piece], end = found_.first[piece + 1], filled = first_step_ + begin;
      const int first_linear = linear;
      while (linear < tape_.sizes.linear_steps && tape_.linear_steps[linear].step < end) ++linear;
      found_.first_input.push(found_.input_count);
      found_.first_operand.push(found_.operands.size());
      found_.first_linear.push(first_linear);
      if (found_.solves[piece] != cuts::none) {
        found_.factors.push(0);
        found_.numbers.push(0);
        continue;
      }
      mark_inputs(begin, end, first_linear, linear);
      const int inputs = list_inputs(filled);
      for (int step = begin; step < end; ++step) {
        const operation op = ops[step];
        if (op >= operation::pair) continue;
        const int first = first_operand[step];
        a[step] = first < filled ? number[first] : inputs + first - filled;
        if (op <= operation::divide ? op == operation::negate : !symbolic::is_binary(op)) continue;
        const int second = second_operand[step];
        b[step] = second < filled ? number[second] : inputs + second - filled;
      }
      for (int k = first_linear; k < linear; ++k) {
        const linear_step& e = tape_.linear_steps[k];
        for (int i = 0; i < e.inputs(); ++i) {
          const int slot = tape_.operands[e.operands + i];
          found_.operands.push(slot < filled ? number[slot] : inputs + slot - filled);
        }
        if (factors_of(e) == 0)
          found_.factors.push(e.factors);
        else
          found_.factors.push(e.factors < filled ? number[e.factors] : inputs + e.factors - filled);
      }
    }
    found_.first_input.push(found_.input_count);
    found_.first_operand.push(found_.operands.size());
    found_.first_linear.push(linear);
  }

  /// Marks the slots that a piece reads but does not fill, one bit for each.
  constexpr void mark_inputs(int begin, int end, int first_linear, int end_linear) {
    const int filled = first_step_ + begin;
    const auto& ops = tape_.op;
    const auto &a = tape_.a, &b = tape_.b;
    auto& word = word_;
    for (int i = 0; i <= filled / 64; ++i) word[i] = 0;
    for (int step = begin; step < end; ++step) {
      const operation op = ops[step];
      if (op >= operation::pair) continue;
      const int first = a[step];
      if (first < filled) word[first / 64] |= std::uint64_t{1} << (first % 64);
      if (op <= operation::divide ? op == operation::negate : !symbolic::is_binary(op)) continue;
      const int second = b[step];
      if (second < filled) word[second / 64] |= std::uint64_t{1} << (second % 64);
    }
    const auto mark = [&](int slot) {
      if (slot < filled) word[slot / 64] |= std::uint64_t{1} << (slot % 64);
    };
    for (int k = first_linear; k < end_linear; ++k) {
      const linear_step& e = tape_.linear_steps[k];
      for (int i = 0; i < e.inputs(); ++i) mark(tape_.operands[e.operands + i]);
      for (int i = 0; i < factors_of(e); ++i) mark(e.factors + i);
    }
  }

  /// Lists the marked slots and returns their number.
  constexpr int list_inputs(int filled) {
    const int numbers = tape_.sizes.numbers;
    const auto& word = word_;
    auto &list = inputs_, &number = number_;
    int inputs = 0, of_numbers = 0, all = found_.input_count;
    for (int i = 0; i <= filled / 64; ++i)
      for (std::uint64_t rest = word[i]; rest != 0; rest &= rest - 1) {
        const int slot = 64 * i + __builtin_ctzll(rest);
        list[all++] = slot;
        number[slot] = inputs++;
        if (slot < numbers) ++of_numbers;
      }
    found_.numbers.push(of_numbers);
    found_.input_count = all;
    return inputs;
  }

  using array = base::zeros<int>::array<true>;

  const Tape& tape_;
  int count_, slots_, first_step_, uncut_, length_;
  base::zeros<int> last_uses_, changes_;
  cuts found_;
  base::zeros<int> numbers_of_slots_{slots_};
  base::zeros<std::uint64_t> words_{slots_ / 64 + 1};
  array &last_use_{last_uses_.elements<true>()}, ///< the last step that reads each slot
      &change_{changes_.elements<true>()},       ///< the number of values that are live before each step
      &number_{numbers_of_slots_.elements<true>()}, &place_{found_.place.elements<true>()},
      &inputs_{found_.inputs.elements<true>()}, &a_{found_.a.elements<true>()},
      &b_{found_.b.elements<true>()};
  base::zeros<std::uint64_t>::array<true>& word_{words_.elements<true>()};
};

} // namespace detail

} // namespace kanexpr::lower
