#pragma once

#include <kanexpr/lower/cuts.hpp>
#include <kanexpr/lower/fixed_tape.hpp>
#include <kanexpr/lower/scalar_math.hpp>
#include <kanexpr/lower/unrolled_tape.hpp>

#include <type_traits>
#include <utility>

namespace kanexpr::lower {

/// The lengths of tapes, in steps.
struct lengths {
  int longest_uncut = 8000; ///< of a tape that is expanded in one function
  int piece = 1500;
};

/// The lengths for a tape that is a constant of the type `Code`; it may be specialized.
template <class Code>
inline constexpr lengths lengths_of{};

/// Steps on vectors are cut into pieces of their own. Depends on the type of the numbers, so that a class that
/// names `evaluated_tape` derives no code before it is called.
template <class Code, class Number>
inline constexpr bool is_cut =
    Code::tape.sizes.steps > lengths_of<Code>.longest_uncut && !uses_vectors<Code, Number>();

/// The cuts of the tape of `Code` as arrays that outlive constant evaluation.
template <class Code>
class cuts_of {
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

    constexpr arrays() {
      const tape_view view(tape);
      const cuts all =
          detail::cutting(view, tape.sizes.first_angle + 2 * tape.sizes.angles, lengths_of<Code>.piece).run();
      pieces = all.first.size() - 1, places = all.places;
      copy(all.first, first), copy(all.first_input, first_input), copy(all.first_operand, first_operand);
      copy(all.first_linear, first_linear), copy(all.numbers, numbers), copy(all.inputs, inputs);
      copy(all.a, a), copy(all.b, b), copy(all.operands, operands), copy(all.factors, factors);
      copy(all.place, place);
    }
    static constexpr void copy(const sequence<int>& from, int* to) {
      const int* const each = from.begin();
      for (int i = 0, end = from.size(); i < end; ++i) to[i] = each[i];
    }
  };

public:
  static constexpr arrays value{};
};

/// A piece of the tape of `Code`, which reads and writes places in memory.
template <class Code, int index>
struct piece_code {
private:
  static constexpr const auto& whole = Code::tape;
  static constexpr const auto& cut = cuts_of<Code>::value;
  static constexpr int first = cut.first[index], first_input = cut.first_input[index],
                       first_operand = cut.first_operand[index], first_linear = cut.first_linear[index],
                       numbers = cut.numbers[index];
  static constexpr tape_sizes sizes{.steps = cut.first[index + 1] - first,
                                    .numbers = numbers,
                                    .loads = cut.first_input[index + 1] - first_input - numbers,
                                    .linear_steps = cut.first_linear[index + 1] - first_linear,
                                    .operands = cut.first_operand[index + 1] - first_operand,
                                    .externals = whole.sizes.externals,
                                    .first_angle = index == 0 ? whole.sizes.first_angle : 0,
                                    .angles = index == 0 ? whole.sizes.angles : 0};

  static constexpr fixed_tape<sizes> made() {
    fixed_tape<sizes> piece{};
    piece.sizes = sizes;
    for (int i = 0; i < sizes.steps; ++i) {
      piece.op[i] = whole.op[first + i];
      piece.paired[i] = whole.paired[first + i];
      piece.a[i] = cut.a[first + i];
      piece.b[i] = cut.b[first + i];
    }
    for (int i = 0; i < numbers; ++i) piece.numbers[i] = whole.numbers[cut.inputs[first_input + i]];
    for (int i = 0; i < sizes.loads; ++i)
      piece.loads[i].position = cut.place[cut.inputs[first_input + numbers + i]];
    for (int i = 0, operands = 0; i < sizes.linear_steps; ++i) {
      linear_step& e = piece.linear_steps[i];
      e = whole.linear_steps[first_linear + i];
      e.step -= first;
      e.factors = cut.factors[first_linear + i];
      e.operands = operands;
      operands += e.inputs();
    }
    for (int i = 0; i < sizes.operands; ++i) piece.operands[i] = cut.operands[first_operand + i];
    for (int i = 0; i < sizes.externals; ++i) piece.externals[i] = whole.externals[i];
    return piece;
  }

public:
  static constexpr fixed_tape<sizes> tape = made();
  /// Whether other pieces read the value of a step, and its place in memory.
  struct destinations {
    bool is_kept[static_cast<std::size_t>(sizes.steps)]{};
    int place[static_cast<std::size_t>(sizes.steps)]{};
    constexpr destinations() {
      for (int i = 0, slot = whole.first_step() + first; i < sizes.steps; ++i, ++slot)
        if (cut.place[slot] != cuts::none) is_kept[i] = true, place[i] = cut.place[slot];
    }
  };
  static constexpr destinations to{};
};

/// Evaluation of a long tape as several functions, because the time and the memory of a compiler grow faster
/// than the length of a function. The operations and their order are those of `unrolled_tape`.
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
    run(memory_, std::make_integer_sequence<int, cut.pieces>{});
  }

  template <int index>
  [[gnu::always_inline]] const Number& result() const noexcept {
    return memory_[place_of_result(index)];
  }
  /// The result with an index that is known only at run time.
  [[gnu::always_inline]] const Number& result_at(int index) const noexcept {
    return memory_[result_place.of[index]];
  }

private:
  static constexpr const auto& cut = cuts_of<Code>::value;

  static consteval int place_of_result(int result) { return cut.place[tape.results[result]]; }
  struct places_of_results {
    int of[tape.sizes.results > 0 ? tape.sizes.results : 1]{};
    constexpr places_of_results() {
      for (int i = 0; i < tape.sizes.results; ++i) of[i] = cut.place[tape.results[i]];
    }
  };
  static constexpr places_of_results result_place{};

  template <class Arguments, int... index>
  [[gnu::always_inline]] void load([[maybe_unused]] const Arguments& arguments,
                                   std::integer_sequence<int, index...>) noexcept {
    ((memory_[cut.place[tape.sizes.numbers + index]] =
          arguments.template operator()<tape.loads[index].from, tape.loads[index].position>()),
     ...);
  }

  template <int... index>
  [[gnu::noinline]] static void run(Number* memory, std::integer_sequence<int, index...>) noexcept {
    store_numbers(memory, std::make_integer_sequence<int, tape.sizes.numbers>{});
    (piece<index>(memory), ...);
  }

  /// Numbers that are results.
  template <int... number>
  [[gnu::always_inline]] static void store_numbers(Number* memory,
                                                   std::integer_sequence<int, number...>) noexcept {
    (store_number<number, cut.place[number]>(memory), ...);
  }
  template <int number, int place>
  [[gnu::always_inline]] static void store_number([[maybe_unused]] Number* memory) noexcept {
    if constexpr (place != cuts::none) memory[place] = number_as<Number>(tape.numbers[number]);
  }

  template <int index>
  [[gnu::noinline]] static void piece(Number* memory) noexcept {
    unrolled_tape<piece_code<Code, index>, Number>::run_in(memory);
  }

  Number memory_[cut.places > 0 ? cut.places : 1];
};

/// The evaluation of a tape, in pieces if it is long.
template <class Code, class Number>
using evaluated_tape =
    std::conditional_t<is_cut<Code, Number>, tape_in_pieces<Code, Number>, unrolled_tape<Code, Number>>;

} // namespace kanexpr::lower
