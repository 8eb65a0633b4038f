#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/base/zeros.hpp>
#include <kanexpr/lower/cuts.hpp>
#include <kanexpr/lower/fixed_tape.hpp>
#include <kanexpr/lower/lockstep_tape.hpp>
#include <kanexpr/lower/scalar_math.hpp>
#include <kanexpr/lower/unrolled_piece.hpp>
#include <kanexpr/lower/unrolled_tape.hpp>
#include <kanexpr/lower/vector_columns.hpp>
#include <kanexpr/symbolic/graph/external.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace kanexpr::lower {

/// The lengths of tapes, in steps.
struct lengths {
  int longest_uncut = 30000;       ///< of a tape that is expanded in one function
  int piece = 1500;                ///< of a part of a longer tape
  int shortest_in_lockstep = 2000; ///< of a tape that is examined for equal branches
  int longest_at_calls = 2000;     ///< of a tape that is expanded at every call
};

/// The lengths for a tape that is a constant of the type `Code`; it may be specialized.
template <class Code>
inline constexpr lengths lengths_of{};

/// Whether a tape solves symmetric systems for many columns, which are solved in memory.
template <class Code>
inline constexpr bool solves_columns = [] {
  for (int i = 0; i < Code::tape.sizes.linear_steps; ++i)
    if (Code::tape.linear_steps[i].op == operation::symmetric_solve) return true;
  return false;
}();

/// Whether a tape is too long for one function.
template <class Code>
inline constexpr bool is_long = Code::tape.sizes.steps > lengths_of<Code>.longest_uncut;

/// Depends on the type of the numbers, so that a class that names `evaluated_tape` derives no code before it
/// is called.
template <class Code, class Number>
inline constexpr bool is_cut = solves_columns<Code> || is_long<Code>;

/// The cuts of the tape of `Code` as arrays that outlive constant evaluation.
template <class Code>
class cuts_of {
  static_assert(lengths_of<Code>.piece > 0, "a piece of a tape has at least one step");
  static constexpr const auto& tape = Code::tape;
  static constexpr std::size_t room(int n) { return static_cast<std::size_t>(n) + 1; }

  struct arrays {
    int pieces = 0, places = 0;
    int first[room(tape.sizes.steps)]{}, first_input[room(tape.sizes.steps)]{},
        first_operand[room(tape.sizes.steps)]{}, first_linear[room(tape.sizes.steps)]{},
        numbers[room(tape.sizes.steps)]{};
    int inputs[room(2 * tape.sizes.steps + tape.sizes.operands)]{};
    int a[room(tape.sizes.steps)]{}, b[room(tape.sizes.steps)]{};
    int operands[room(tape.sizes.operands)]{}, factors[room(tape.sizes.linear_steps)]{};
    int place[room(tape.slot_count())]{};
    int solves[room(tape.sizes.steps)]{}, columns[room(tape.sizes.linear_steps)]{};

    constexpr arrays() {
      const cuts all = detail::cutting(tape, tape.sizes.first_angle + 2 * tape.sizes.angles,
                                       is_long<Code> ? lengths_of<Code>.piece : tape.sizes.steps)
                           .run();
      pieces = all.first.size() - 1, places = all.places;
      copy(all.first, first), copy(all.first_input, first_input), copy(all.first_operand, first_operand);
      copy(all.first_linear, first_linear), copy(all.numbers, numbers), copy(all.operands, operands);
      copy(all.inputs, inputs, all.input_count), copy(all.factors, factors);
      copy(all.a, a, tape.sizes.steps), copy(all.b, b, tape.sizes.steps);
      copy(all.place, place, tape.slot_count()), copy(all.solves, solves), copy(all.columns, columns);
    }
    static constexpr void copy(const sequence<int>& from, int* to) {
      const int* const each = from.begin();
      for (int i = 0, end = from.size(); i < end; ++i) to[i] = each[i];
    }
    template <std::size_t room>
    static constexpr void copy(const base::zeros<int>& from, int (&to)[room], int count) {
      const auto& each = from.elements<true>();
      for (int i = 0; i < count; ++i) to[i] = each[i];
    }
  };

public:
  static constexpr arrays value{};
};

/// Whether the steps before the first symmetric system run in lockstep for equal branches: if they are many,
/// and the target has vectors with a lane for each branch.
template <class Code, class Number>
inline constexpr bool runs_in_lockstep = [] {
  if constexpr (Code::tape.sizes.steps < lengths_of<Code>.shortest_in_lockstep ||
                lanes_for_columns<Number>() < 2) {
    return false;
  } else {
    return lockstep_plan<Code, cuts_of<Code>, lanes_for_columns<Number>()>::value.lanes != 0;
  }
}();

/// The first step of a piece, its first inputs, and its sizes.
struct piece_extent {
  int first = 0, first_input = 0, first_operand = 0, first_linear = 0;
  tape_sizes sizes{};

  template <class Arrays>
  constexpr piece_extent(const Arrays& cut, const tape_sizes& whole, int index)
      : first(cut.first[index]), first_input(cut.first_input[index]), first_operand(cut.first_operand[index]),
        first_linear(cut.first_linear[index]) {
    sizes.steps = cut.first[index + 1] - first;
    sizes.numbers = cut.numbers[index];
    sizes.loads = cut.first_input[index + 1] - first_input - sizes.numbers;
    sizes.linear_steps = cut.first_linear[index + 1] - first_linear;
    sizes.operands = cut.first_operand[index + 1] - first_operand;
    sizes.externals = whole.externals;
    if (index == 0) sizes.first_angle = whole.first_angle, sizes.angles = whole.angles;
  }
};

/// A piece of a tape, with the members of a `fixed_tape` that its evaluation reads. What it has for each step
/// remains in the arrays of the whole tape and of its cuts.
template <tape_sizes own>
struct tape_piece {
  static constexpr std::size_t at_least_one(int n) { return n > 0 ? static_cast<std::size_t>(n) : 1; }

  tape_sizes sizes;
  const operation* op;
  const bool* paired;
  const int *a, *b; ///< slots of the piece
  const int* to;    ///< the place in memory where each step is stored; none if no other piece reads it
  const int* operands;
  const int* inputs; ///< slots of the whole tape, those of numbers first
  const int* places; ///< of the slots of the whole tape
  symbolic::number numbers[at_least_one(own.numbers)]{};
  linear_step linear_steps[at_least_one(own.linear_steps)]{};
  const symbolic::external_function* externals[at_least_one(own.externals)]{};

  // the large arrays are arguments: in g++, each access to a constant by its name may copy it
  template <class Tape, class Arrays>
  constexpr tape_piece(const Tape& whole, const Arrays& cut, const piece_extent& extent)
      : sizes(own), op(whole.op + extent.first), paired(whole.paired + extent.first), a(cut.a + extent.first),
        b(cut.b + extent.first), to(cut.place + whole.first_step() + extent.first),
        operands(cut.operands + extent.first_operand), inputs(cut.inputs + extent.first_input),
        places(cut.place) {
    for (int i = 0; i < own.numbers; ++i) numbers[i] = whole.numbers[inputs[i]];
    for (int i = 0, next = 0; i < own.linear_steps; ++i) {
      linear_step& e = linear_steps[i];
      e = whole.linear_steps[extent.first_linear + i];
      e.step -= extent.first;
      e.factors = cut.factors[extent.first_linear + i];
      e.operands = next;
      next += e.inputs();
    }
    for (int i = 0; i < own.externals; ++i) externals[i] = whole.externals[i];
  }

  constexpr int first_step() const { return own.numbers + own.loads; }
  constexpr int slot_count() const { return first_step() + own.steps; }
  /// The place in memory of an input other than a number.
  constexpr int place_of_load(int index) const { return places[inputs[own.numbers + index]]; }
};

/// A piece of the tape of `Code`, which reads and writes places in memory.
template <class Code, int index>
struct piece_code {
private:
  static constexpr piece_extent extent{cuts_of<Code>::value, Code::tape.sizes, index};

public:
  static constexpr tape_piece<extent.sizes> tape{Code::tape, cuts_of<Code>::value, extent};
};

/// Evaluation of a long tape as several functions, because the time that a compiler needs to optimize a
/// function grows faster than its length. The operations and their order are those of `unrolled_tape`.
///
/// Values that several pieces use are in one array, each at a constant place; all other values are in
/// registers.
template <class Code, class Number>
class tape_in_pieces {
public:
  static constexpr const auto& tape = Code::tape;

  /// `arguments(load)` returns the value of each load.
  template <class Arguments>
  [[gnu::always_inline]] explicit tape_in_pieces(const Arguments& arguments) noexcept {
    load(arguments, std::make_integer_sequence<int, tape.sizes.loads>{});
    run(memory_, std::make_integer_sequence<int, pieces>{});
  }

  /// The place in memory of a result that is computed.
  static constexpr int place_of_result(int result) {
    return cuts_of<Code>::value.place[tape.results[result]];
  }
  [[gnu::always_inline]] const Number* memory() const noexcept { return memory_; }

  template <int index>
  [[gnu::always_inline]] Number result() const noexcept {
    if constexpr (tape.results[index] < tape.sizes.numbers) {
      return number_as<Number>(tape.numbers[tape.results[index]]);
    } else {
      constexpr int place = place_of_result(index);
      return memory_[place];
    }
  }

private:
  static constexpr int pieces = cuts_of<Code>::value.pieces, places = cuts_of<Code>::value.places;

  struct slot_places {
    static consteval int of(int slot) { return cuts_of<Code>::value.place[slot]; }
    static consteval int columns(int linear_step) { return cuts_of<Code>::value.columns[linear_step]; }
  };
  static consteval int solved_by(int piece) { return cuts_of<Code>::value.solves[piece]; }

  /// The arguments have the first places.
  template <class Arguments, int... index>
  [[gnu::always_inline]] void load([[maybe_unused]] const Arguments& arguments,
                                   std::integer_sequence<int, index...>) noexcept {
    ((memory_[index] = arguments.template operator()<tape.loads[index].from, tape.loads[index].position>()),
     ...);
  }

  template <int... index>
  [[gnu::noinline]] static void run(Number* memory, std::integer_sequence<int, index...>) noexcept {
    (piece<index>(memory), ...);
  }

  template <int index>
  [[gnu::noinline]] static void piece(Number* memory) noexcept {
    if constexpr (solved_by(index) >= 0)
      vector_columns<Code, solved_by(index), Number, slot_places>::run(memory);
    else if constexpr (index == 0 && runs_in_lockstep<Code, Number>)
      lockstep_tape<Code, cuts_of<Code>, Number>::run_in(memory);
    else
      unrolled_piece<piece_code<Code, index>, Number>::run(memory);
  }

  Number memory_[static_cast<std::size_t>(places > 0 ? places : 1)];
};

/// The evaluation of a tape, in pieces if it is long.
template <class Code, class Number>
using evaluated_tape =
    std::conditional_t<is_cut<Code, Number>, tape_in_pieces<Code, Number>, unrolled_tape<Code, Number>>;

} // namespace kanexpr::lower
