#pragma once

#include <kanexpr/lower/fixed_tape.hpp>
#include <kanexpr/lower/long_lists.hpp>
#include <kanexpr/lower/scalar_math.hpp>
#include <kanexpr/lower/unrolled_steps.hpp>

#include <cstddef>

namespace kanexpr::lower {

/// Straight-line evaluation of a tape that is a constant of the type `Code` (`Code::tape`).
///
/// Every index is a constant, and all steps are in one function, each at the position of its slot in one
/// initializer, so compilers replace the array by registers before any other optimization. If there were a
/// pointer to the slots, they would analyze the memory accesses of every step again after each level of
/// inlining.
template <class Code, class Number>
class unrolled_tape : unrolled_steps<Code, Number> {
  using steps = unrolled_steps<Code, Number>;
  using steps::a_of_step, steps::b_of_step, steps::angles, steps::aside_of, steps::at_least_one,
      steps::first_angle, steps::given_before, steps::plan, steps::what;
  using typename steps::operand;

public:
  using steps::tape;

  /// `arguments(load)` returns the value of each load.
  template <class Arguments>
  [[gnu::always_inline]] explicit unrolled_tape(const Arguments& arguments) noexcept {
    run(arguments, up_to<tape.sizes.numbers>, up_to<plan.early_count>, up_to<first_angle>, up_to<angles>,
        up_to<given_before>, up_to<2 * angles>, up_to<plan.entries>, up_to<tape.sizes.results>);
  }

  template <int index>
  [[gnu::always_inline]] const Number& result() const noexcept {
    return result_[index];
  }

private:
  static consteval int a(int entry) { return plan.a[entry / row_length][entry % row_length]; }
  static consteval int b(int entry) { return plan.b[entry / row_length][entry % row_length]; }
  static consteval int place_of(int result) { return plan.place_of(tape.results[result]); }
  static consteval load early(int index) { return tape.loads[plan.early[index]]; }

  /// A single call computes the sines and cosines of all angles that are known at the start; a scalar type
  /// may replace the function that it calls.
  template <class Arguments, int... number, int... load, int... before, int... angle, int... known,
            int... turned, int... entry, int... result>
  [[gnu::always_inline]] void run([[maybe_unused]] const Arguments& arguments, indices<number...>,
                                  indices<load...>, indices<before...>, indices<angle...>, indices<known...>,
                                  indices<turned...>, indices<entry...>, indices<result...>) noexcept {
    [[maybe_unused]] const Number given[at_least_one(given_before)] {
      number_as<Number>(tape.numbers[number])...,
      arguments.template operator()<early(load).from, early(load).position>()...,
      apply<tape.op[before], Number>(given[a_of_step(before)], given[b_of_step(before)])...
    };
    [[maybe_unused]] Number sine[at_least_one(angles)], cosine[at_least_one(angles)];
    if constexpr (angles > 0) {
      const Number all[]{given[a_of_step(first_angle + 2 * angle)]...};
      scalar_math<Number>::template sincos<static_cast<std::size_t>(angles)>(all, sine, cosine);
    }
    [[maybe_unused]] Number aside[at_least_one(plan.aside_count)];
    [[maybe_unused]] const Number slot[at_least_one(tape.slot_count())]{
        given[known]..., (turned % 2 == 0 ? sine : cosine)[turned / 2]...,
        take<what(entry)>(slot[a(entry)], slot[b(entry)],
                          plan.uses_aside(what(entry)) ? aside + aside_of(entry) : nullptr,
                          what(entry) < 0 ? slot : nullptr, arguments)...};
    const int order[]{0, (result_[result] = slot[place_of(result)], 0)...};
    static_cast<void>(order);
  }

  /// Returns the value of an entry.
  template <int what, class Arguments>
  [[gnu::always_inline]] static Number take(operand a, operand b, Number* aside, const Number* slot,
                                            [[maybe_unused]] const Arguments& arguments) noexcept {
    if constexpr (what <= plan.first_argument) {
      constexpr load from = tape.loads[plan.first_argument - what];
      return arguments.template operator()<from.from, from.position>();
    } else {
      return steps::template step<what>(a, b, aside, slot);
    }
  }

  Number result_[at_least_one(tape.sizes.results)];
};

} // namespace kanexpr::lower
