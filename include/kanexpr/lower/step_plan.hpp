#pragma once

#include <kanexpr/lower/fixed_tape.hpp>
#include <kanexpr/lower/long_lists.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

#include <cstddef>

namespace kanexpr::lower {

/// The order in which the slots of a tape are filled when it is unrolled, and what fills each of them: its
/// action.
///
/// The numbers, the steps before the angles, their arguments, and the angles come first. The other steps
/// follow in their order. Each is preceded by the arguments that it is the first to use: compilers keep that
/// order, and an argument that is read long before its use takes a register from another value.
///
/// Actions are encoded as numbers, so that all entries with the same action share one function. A step that
/// fills several slots stores its values in scratch memory, from which each slot takes its value.
///
/// Long arrays are divided into rows.
template <class Code>
struct step_plan {
  static constexpr const auto& tape = Code::tape;
  /// The actions other than operations and components: a sine with its cosine, the linear steps from
  /// `first_linear_step` downward, and the arguments from `first_argument` downward.
  static constexpr int sine_and_cosine = -1, first_linear_step = -2,
                       first_argument = first_linear_step - tape.sizes.linear_steps;
  static constexpr int component = static_cast<int>(operation::component);
  static constexpr int behind = tape.sizes.first_angle + 2 * tape.sizes.angles; ///< the angles

  static constexpr std::size_t at_least_one(int n) { return n > 0 ? static_cast<std::size_t>(n) : 1; }
  static constexpr std::size_t room = rows_for(tape.slot_count());

  int place[room][row_length]{};               ///< of each slot of the tape, in the order of filling
  int early[at_least_one(tape.sizes.loads)]{}; ///< the arguments that are read first
  int early_count = 0;
  int what[room][row_length]{};                     ///< the action of each entry: of what follows the angles
  int a[room][row_length]{}, b[room][row_length]{}; ///< the places of its operands, or `stored` ones
  int step[room][row_length]{};                     ///< the step that it is; none for an argument
  int aside[room][row_length]{};                    ///< its scratch memory
  int entries = 0, aside_count = 0;
  int operands[at_least_one(tape.sizes.operands)]{}; ///< of the linear steps: places
  static constexpr int none = -1;

  constexpr step_plan() {
    find_late_arguments();
    for (int i = 0; i < numbers; ++i) place[i / row_length][i % row_length] = i;
    for (int i = 0, slot = numbers; i < tape.sizes.loads; ++i, ++slot) {
      if (is_late[slot / row_length][slot % row_length]) continue;
      place[slot / row_length][slot % row_length] = numbers + early_count;
      early[early_count++] = i;
    }
    for (int i = 0, slot = first_step; i < behind; ++i, ++slot)
      place[slot / row_length][slot % row_length] = numbers + early_count + i;
    for (int i = behind, linear = 0; i < tape.sizes.steps; ++i) {
      const int first = tape.a[i], second = tape.b[i];
      if constexpr (!is_piece) {
        if (is_late[first / row_length][first % row_length]) read(first);
        if (is_late[second / row_length][second % row_length]) read(second);
      }
      if (linear < tape.sizes.linear_steps && tape.linear_steps[linear].step == i)
        add_linear(linear++);
      else
        add(i, !tape.paired[i]                ? static_cast<int>(tape.op[i])
               : tape.op[i] == operation::sin ? sine_and_cosine
                                              : component);
    }
  }

  constexpr int place_of(int slot) const { return place[slot / row_length][slot % row_length]; }

  /// The place in memory of an operand that a piece reads there, as a negative number; or that place again.
  static constexpr int stored(int place) { return ~place; }

  static constexpr bool uses_aside(int action) {
    return (action < 0 && action > first_argument) || action == component;
  }

private:
  /// A piece has its arguments in memory. Only linear steps require them in slots.
  static constexpr bool is_piece = !requires { tape.loads; };
  static constexpr int numbers = tape.sizes.numbers, first_step = tape.first_step();

  /// Arguments that some step behind the angles uses, but nothing before. Operations with one operand name
  /// slot 0 as the other, which is therefore filled first.
  constexpr void find_late_arguments() {
    for (int i = behind; i < tape.sizes.steps; ++i) {
      const int first = tape.a[i], second = tape.b[i];
      is_late[first / row_length][first % row_length] = true;
      is_late[second / row_length][second % row_length] = true;
    }
    for (int i = 0; i < tape.sizes.operands; ++i) set_late(tape.operands[i], true);
    for (int i = 0; i < behind; ++i) set_late(tape.a[i], false), set_late(tape.b[i], false);
    for (int i = 0; i < numbers; ++i) set_late(i, false);
    for (int i = first_step; i < tape.slot_count(); ++i) is_late[i / row_length][i % row_length] = false;
    set_late(0, false);
  }

  constexpr void set_late(int slot, bool is) { is_late[slot / row_length][slot % row_length] = is; }

  constexpr void read(int slot) {
    set_late(slot, false);
    place[slot / row_length][slot % row_length] = numbers + early_count + behind + entries;
    step[entries / row_length][entries % row_length] = none;
    what[entries / row_length][entries % row_length] = first_argument - (slot - numbers);
    ++entries;
  }

  constexpr void add(int i, int action) {
    const int slot = first_step + i, row = entries / row_length, column = entries % row_length;
    const int first = tape.a[i], second = tape.b[i];
    place[slot / row_length][slot % row_length] = numbers + early_count + behind + entries;
    step[row][column] = i;
    what[row][column] = action;
    a[row][column] = operand(first);
    b[row][column] = operand(second);
    if (uses_aside(action)) aside[row][column] = aside_count++;
    ++entries;
  }

  constexpr int operand(int slot) const {
    if constexpr (is_piece)
      if (is_late[slot / row_length][slot % row_length]) return stored(tape.place_of_load(slot - numbers));
    return place_of(slot);
  }

  constexpr void add_linear(int index) {
    const linear_step& e = tape.linear_steps[index];
    for (int i = e.operands; i < e.operands + e.inputs(); ++i) {
      const int slot = tape.operands[i];
      if (is_late[slot / row_length][slot % row_length]) read(slot);
      operands[i] = place_of(slot);
    }
    add(e.step, first_linear_step - index);
  }

  bool is_late[room][row_length]{};
};

} // namespace kanexpr::lower
