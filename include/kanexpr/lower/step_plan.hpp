#pragma once

#include <kanexpr/lower/fixed_tape.hpp>
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
  static constexpr std::size_t room = at_least_one(tape.slot_count());

  int place[room]{};                           ///< of each slot of the tape, in the order of filling
  int early[at_least_one(tape.sizes.loads)]{}; ///< the arguments that are read first
  int early_count = 0;
  int what[room]{};         ///< the action of each entry: of what follows the angles
  int a[room]{}, b[room]{}; ///< the places of its operands
  int step[room]{};         ///< the step that it is; none for an argument
  int aside[room]{};        ///< its scratch memory
  int entries = 0, aside_count = 0;
  int operands[at_least_one(tape.sizes.operands)]{}; ///< of the linear steps: places
  static constexpr int none = -1;

  constexpr step_plan() {
    find_late_arguments();
    for (int i = 0; i < numbers; ++i) place[i] = i;
    for (int i = 0; i < tape.sizes.loads; ++i) {
      if (is_late[numbers + i]) continue;
      place[numbers + i] = numbers + early_count;
      early[early_count++] = i;
    }
    for (int i = 0; i < behind; ++i) place[first_step + i] = numbers + early_count + i;
    for (int i = behind, linear = 0; i < tape.sizes.steps; ++i) {
      if (is_late[tape.a[i]]) read(tape.a[i]);
      if (is_late[tape.b[i]]) read(tape.b[i]);
      if (linear < tape.sizes.linear_steps && tape.linear_steps[linear].step == i)
        add_linear(linear++);
      else
        add(i, !tape.paired[i]                ? static_cast<int>(tape.op[i])
               : tape.op[i] == operation::sin ? sine_and_cosine
                                              : component);
    }
  }

  static constexpr bool uses_aside(int action) {
    return (action < 0 && action > first_argument) || action == component;
  }

private:
  static constexpr int numbers = tape.sizes.numbers, first_step = tape.first_step();

  /// Arguments that some step behind the angles uses, but nothing before. Operations with one operand name
  /// slot 0 as the other, which is therefore filled first.
  constexpr void find_late_arguments() {
    for (int i = behind; i < tape.sizes.steps; ++i) is_late[tape.a[i]] = is_late[tape.b[i]] = true;
    for (int i = 0; i < tape.sizes.operands; ++i) is_late[tape.operands[i]] = true;
    for (int i = 0; i < behind; ++i) is_late[tape.a[i]] = is_late[tape.b[i]] = false;
    for (int i = 0; i < numbers; ++i) is_late[i] = false;
    for (int i = first_step; i < tape.slot_count(); ++i) is_late[i] = false;
    is_late[0] = false;
  }

  constexpr void read(int slot) {
    is_late[slot] = false;
    place[slot] = numbers + early_count + behind + entries;
    step[entries] = none;
    what[entries++] = first_argument - (slot - numbers);
  }

  constexpr void add(int i, int action) {
    place[first_step + i] = numbers + early_count + behind + entries;
    step[entries] = i;
    what[entries] = action;
    a[entries] = place[tape.a[i]], b[entries] = place[tape.b[i]];
    if (uses_aside(action)) aside[entries] = aside_count++;
    ++entries;
  }

  constexpr void add_linear(int index) {
    const linear_step& e = tape.linear_steps[index];
    for (int i = e.operands; i < e.operands + e.inputs(); ++i) {
      if (is_late[tape.operands[i]]) read(tape.operands[i]);
      operands[i] = place[tape.operands[i]];
    }
    add(e.step, first_linear_step - index);
  }

  bool is_late[room]{};
};

} // namespace kanexpr::lower
