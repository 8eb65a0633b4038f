#pragma once

#include <kanexpr/lower/long_lists.hpp>
#include <kanexpr/lower/scalar_math.hpp>
#include <kanexpr/lower/unrolled_steps.hpp>

#include <cstddef>

namespace kanexpr::lower {

/// Straight-line evaluation of a piece of a longer tape, like that of `unrolled_tape`, but the arguments are
/// places in memory, and steps whose values other pieces use store them at once, so that they need no
/// register until the end.
///
/// Steps read arguments directly from memory, because an entry for each of them would be a function of its
/// own while compilers expand the piece.
template <class Code, class Number>
class unrolled_piece : unrolled_steps<Code, Number> {
  using steps = unrolled_steps<Code, Number>;
  using steps::a_of_step, steps::b_of_step, steps::angles, steps::aside_of, steps::at_least_one,
      steps::first_angle, steps::given_before, steps::plan, steps::tape, steps::what;
  using typename steps::operand;

  static consteval bool is_stored_step(int step) { return tape.to[step] >= 0; }
  static consteval int place_of_step(int step) { return is_stored_step(step) ? tape.to[step] : 0; }
  static consteval int place_of_early(int index) { return tape.place_of_load(plan.early[index]); }

  // of entries
  static consteval bool is_a_stored(int entry) { return plan.a[entry / row_length][entry % row_length] < 0; }
  static consteval bool is_b_stored(int entry) { return plan.b[entry / row_length][entry % row_length] < 0; }
  static consteval int a(int entry) { return place_in(plan.a[entry / row_length][entry % row_length]); }
  static consteval int b(int entry) { return place_in(plan.b[entry / row_length][entry % row_length]); }
  static consteval int place_in(int operand) { return operand < 0 ? plan.stored(operand) : operand; }
  static consteval int step_of(int entry) { return plan.step[entry / row_length][entry % row_length]; }
  static consteval bool is_stored(int entry) {
    return step_of(entry) != plan.none && is_stored_step(step_of(entry));
  }
  static consteval int place(int entry) {
    if (step_of(entry) == plan.none) return tape.place_of_load(plan.first_argument - what(entry));
    return place_of_step(step_of(entry));
  }

public:
  [[gnu::always_inline]] static void run(Number* memory) noexcept {
    run(memory, up_to<tape.sizes.numbers>, up_to<plan.early_count>, up_to<first_angle>, up_to<angles>,
        up_to<given_before>, up_to<2 * angles>, group_of_five<plan.entries, 0>,
        group_of_five<plan.entries, 1>, group_of_five<plan.entries, 2>, group_of_five<plan.entries, 3>,
        group_of_five<plan.entries, 4>);
  }

private:
  /// The entries come in five groups.
  template <int... number, int... load, int... before, int... angle, int... known, int... turned, int... e0,
            int... e1, int... e2, int... e3, int... e4>
  [[gnu::always_inline]] static void run(Number* memory, indices<number...>, indices<load...>,
                                         indices<before...>, indices<angle...>, indices<known...>,
                                         indices<turned...>, indices<e0...>, indices<e1...>, indices<e2...>,
                                         indices<e3...>, indices<e4...>) noexcept {
    const Number given[at_least_one(given_before)]{
        number_as<Number>(tape.numbers[number])..., memory[place_of_early(load)]...,
        stored<is_stored_step(before)>(
            apply<tape.op[before], Number>(given[a_of_step(before)], given[b_of_step(before)]),
            memory + place_of_step(before))...};
    [[maybe_unused]] Number sine[at_least_one(angles)], cosine[at_least_one(angles)];
    if constexpr (angles > 0) {
      const Number all[]{given[a_of_step(first_angle + 2 * angle)]...};
      scalar_math<Number>::template sincos<static_cast<std::size_t>(angles)>(all, sine, cosine);
    }
    [[maybe_unused]] Number aside[at_least_one(plan.aside_count)];
    [[maybe_unused]] const Number slot[at_least_one(tape.slot_count())]{
        given[known]...,
        stored<is_stored_step(first_angle + turned)>((turned % 2 == 0 ? sine : cosine)[turned / 2],
                                                     memory + place_of_step(first_angle + turned))...,
        fill<what(e0), is_stored(e0)>((is_a_stored(e0) ? memory : slot)[a(e0)],
                                      (is_b_stored(e0) ? memory : slot)[b(e0)], aside + aside_of(e0), slot,
                                      memory, place(e0))...,
        fill<what(e1), is_stored(e1)>((is_a_stored(e1) ? memory : slot)[a(e1)],
                                      (is_b_stored(e1) ? memory : slot)[b(e1)], aside + aside_of(e1), slot,
                                      memory, place(e1))...,
        fill<what(e2), is_stored(e2)>((is_a_stored(e2) ? memory : slot)[a(e2)],
                                      (is_b_stored(e2) ? memory : slot)[b(e2)], aside + aside_of(e2), slot,
                                      memory, place(e2))...,
        fill<what(e3), is_stored(e3)>((is_a_stored(e3) ? memory : slot)[a(e3)],
                                      (is_b_stored(e3) ? memory : slot)[b(e3)], aside + aside_of(e3), slot,
                                      memory, place(e3))...,
        fill<what(e4), is_stored(e4)>((is_a_stored(e4) ? memory : slot)[a(e4)],
                                      (is_b_stored(e4) ? memory : slot)[b(e4)], aside + aside_of(e4), slot,
                                      memory, place(e4))...};
  }

  /// Returns the value of an entry, and stores it if other pieces use it.
  template <int what, bool is_stored>
  [[gnu::always_inline]] static Number fill(operand a, operand b, Number* aside, const Number* slot,
                                            Number* memory, int place) noexcept {
    if constexpr (what <= plan.first_argument)
      return memory[place];
    else
      return stored<is_stored>(steps::template step<what>(a, b, aside, slot), memory + place);
  }

  template <bool is_stored>
  [[gnu::always_inline]] static Number stored(operand value, [[maybe_unused]] Number* place) noexcept {
    if constexpr (is_stored) *place = value;
    return value;
  }
};

} // namespace kanexpr::lower
