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

template <class Code>
inline constexpr bool is_cut = Code::tape.sizes.steps > lengths_of<Code>.longest_uncut;

/// The cuts of a tape as arrays that outlive constant evaluation.
template <class Code>
class cuts_of {
  static constexpr const auto& tape = Code::tape;
  static constexpr cuts made() {
    const tape_view view(tape);
    return detail::cutting(view, tape.sizes.first_angle + 2 * tape.sizes.angles, lengths_of<Code>.piece)
        .run();
  }
  struct counts {
    int pieces, places;
  };
  static constexpr counts count = [] {
    const cuts all = made();
    return counts{all.first.size() - 1, all.places};
  }();

  struct arrays {
    int first[count.pieces + 1]{};
    int place[tape.slot_count()]{};
    constexpr arrays() {
      const cuts all = made();
      for (int i = 0; i <= count.pieces; ++i) first[i] = all.first[i];
      for (int i = 0; i < tape.slot_count(); ++i) place[i] = all.place[i];
    }
  };
  static constexpr arrays array{};

public:
  static constexpr int pieces = count.pieces, places = count.places;
  static constexpr const int* first = array.first;
  static constexpr const int* place = array.place;
};

/// A piece of the tape of `Code`, which reads and writes places in memory.
template <class Code, int index>
struct piece_code {
private:
  using cut = cuts_of<Code>;
  static constexpr roomy_tape roomy = [] {
    roomy_tape of_piece =
        fixed(piece_of(tape_view(Code::tape), cut::place, cut::first[index], cut::first[index + 1]));
    if constexpr (index == 0) {
      of_piece.sizes.first_angle = Code::tape.sizes.first_angle;
      of_piece.sizes.angles = Code::tape.sizes.angles;
    }
    return of_piece;
  }();

public:
  static constexpr auto tape = trimmed<roomy.sizes>(roomy);
  /// The place in memory of the value of a step, or none.
  static consteval int place_of(int step) {
    return cut::place[Code::tape.first_step() + cut::first[index] + step];
  }
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
    run(memory_, std::make_integer_sequence<int, cut::pieces>{});
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
  using cut = cuts_of<Code>;

  static consteval int place_of_result(int result) { return cut::place[tape.results[result]]; }
  struct places_of_results {
    int of[tape.sizes.results > 0 ? tape.sizes.results : 1]{};
    constexpr places_of_results() {
      for (int i = 0; i < tape.sizes.results; ++i) of[i] = cut::place[tape.results[i]];
    }
  };
  static constexpr places_of_results result_place{};

  template <class Arguments, int... index>
  [[gnu::always_inline]] void load([[maybe_unused]] const Arguments& arguments,
                                   std::integer_sequence<int, index...>) noexcept {
    ((memory_[cut::place[tape.sizes.numbers + index]] =
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
    (store_number<number, cut::place[number]>(memory), ...);
  }
  template <int number, int place>
  [[gnu::always_inline]] static void store_number([[maybe_unused]] Number* memory) noexcept {
    if constexpr (place != cuts::none) memory[place] = number_as<Number>(tape.numbers[number]);
  }

  template <int index>
  [[gnu::noinline]] static void piece(Number* memory) noexcept {
    unrolled_tape<piece_code<Code, index>, Number>::run_in(memory);
  }

  Number memory_[cut::places > 0 ? cut::places : 1];
};

/// The evaluation of a tape, in pieces if it is long.
template <class Code, class Number>
using evaluated_tape =
    std::conditional_t<is_cut<Code>, tape_in_pieces<Code, Number>, unrolled_tape<Code, Number>>;

} // namespace kanexpr::lower
